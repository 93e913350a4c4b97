// SPDX-License-Identifier: Apache-2.0
//
// Messages of the verbs about failures, and findings of the tests of a plugin. Tests refer to the constants and do not repeat the text.
#pragma once

#include "base/sentence.hpp"

namespace swage::tools::say {

using base::operator""_sentence;

// the command line
inline constexpr auto kSayVerb = "Say what {} shall do."_sentence;
inline constexpr auto kNoVerb = "{} has no verb \"{}\".{}"_sentence;  // third: "did you mean"
inline constexpr auto kVerbs = " It has: {}. See: swage --help"_sentence;
inline constexpr auto kSeeHelp = "{}. See: swage {}--help"_sentence;  // message of the command line parser, then "run "
inline constexpr auto kNoTime = "{} is not a time above 0"_sentence;
inline constexpr auto kUnexpected = "{} (this should not happen: please report it)"_sentence;

// files and folders
inline constexpr auto kOfFile = "{}: {}"_sentence;
inline constexpr auto kNothingThere = "There is no {}."_sentence;
inline constexpr auto kNoFile = "There is no file {}."_sentence;
inline constexpr auto kNotJson = "It is not JSON."_sentence;
inline constexpr auto kNotRead = "{} cannot be read."_sentence;
inline constexpr auto kNotWritten = "\"{}\" cannot be written."_sentence;
inline constexpr auto kNotStarted = "{} cannot be started: {}."_sentence;

// the store and its attempts
inline constexpr auto kNoStore = "There is no store {}: no attempt has been kept there yet."_sentence;
inline constexpr auto kOnlyRead = "This store can only be read here: nothing in it is changed."_sentence;
inline constexpr auto kNoAttemptYet = "The store holds no attempt yet."_sentence;
inline constexpr auto kNoAttempt = "There is no attempt \"{}\". \"swage attempts list\" shows them."_sentence;
inline constexpr auto kManyAttempts = "\"{}\" may be {} attempts: give more of the id."_sentence;
inline constexpr auto kAddThem = "{} Add them: swage people add \"{}\"."_sentence;
inline constexpr auto kOutsideAttempt = "--at: {} s is outside of the attempt, which has {} s."_sentence;
inline constexpr auto kOfHome = "--home: {}"_sentence;
inline constexpr auto kFileNotFound = "This store can only be read here: erasing a person will not find this file."_sentence;
inline constexpr auto kBackupThere = "{} is there already: add --force to replace it."_sentence;
inline constexpr auto kNotKept = "the attempt was not kept"_sentence;
inline constexpr auto kNoTrace = "No trace was written: {}"_sentence;
inline constexpr auto kTraceNotWhole = "The trace could not be written whole."_sentence;
inline constexpr auto kAllIsTables =
    "\"all\" is for tables and statements (--as csv, csv-wide, xapi). For the whole store: swage attempts backup."_sentence;
inline constexpr auto kMissingSteps =
    "{} steps are missing from step {} on: the machine was too slow to record them, so this attempt cannot be replayed."_sentence;
inline constexpr auto kNoSteps = "It has no recorded step."_sentence;

// statements that are sent
inline constexpr auto kNoAddress = "--to: \"{}\" is no address; https://lrs.example.org/xapi is. A login goes into a file: --login."_sentence;
inline constexpr auto kNotEncrypted = "--to: \"{}\" is not encrypted: https:// is needed for anything but this machine."_sentence;
inline constexpr auto kOfLogin = "--login: \"{}\": {}"_sentence;
inline constexpr auto kLoginLine = "--login: the file holds one line, user:password."_sentence;
inline constexpr auto kNoCurl = "libcurl does not start."_sentence;
inline constexpr auto kNoAnswer = "There is no answer: {}."_sentence;
inline constexpr auto kAnswers = "It answers {}{}"_sentence;  // a code, then "." or ": " and what was said
inline constexpr auto kNoReceipts = "The receipts cannot be written."_sentence;
inline constexpr auto kWaits = " What waits is sent the next time."_sentence;

// people and courses
inline constexpr auto kFinal = "Erasing {} with {} attempts is final. To do so, add --confirm \"{}\"."_sentence;
inline constexpr auto kNoCourse = "No course is called \"{}\".{}"_sentence;  // second: "did you mean"
inline constexpr auto kNoGroup = "No group is called \"{}\"."_sentence;
inline constexpr auto kNobodyAtAll = "Neither a group nor a person is called \"{}\"."_sentence;
inline constexpr auto kNoLessons = "No lessons are there: name some with --lesson."_sentence;
inline constexpr auto kHandsFail = "{}: its hands could not play it."_sentence;

// swage run
inline constexpr auto kIsAttempt =
    "{} is a kept attempt and no lesson. Step it again with: swage replay {}   or look at it with: swage-console {}"_sentence;
inline constexpr auto kNoConsole = "swage-console is not installed beside this program: running without a window."_sentence;
inline constexpr auto kNoDisplay = "There is no display: running without a window."_sentence;
inline constexpr auto kNoWindow = "It cannot be started: running without a window."_sentence;
inline constexpr auto kIsMouse =
    "\"{}\" is a mouse, and without a window nobody can move it. Choose another hand with --device{}, or an end with --max-time."_sentence;
inline constexpr auto kHandLost = "This hand is lost: its tool holds, and the lesson waits for it. Ctrl-C ends the attempt."_sentence;
inline constexpr auto kNewHere = "{} is new here; the code is {}."_sentence;
inline constexpr auto kNotEntered =
    "{} could not be looked up or entered: {} A name that is new to the store becomes a code, which exports say."_sentence;
inline constexpr auto kInterrupted = "Interrupted: the attempt ends as aborted."_sentence;

// swage study
inline constexpr auto kNeedsFormat = "\"{}\" is needed here"_sentence;
inline constexpr auto kNeedsFactors = "one or two factors are needed here"_sentence;
inline constexpr auto kNeedsText = "a text is needed here"_sentence;
inline constexpr auto kNeedsHand = "at least one hand is needed here"_sentence;
inline constexpr auto kUnknown = "unknown here"_sentence;
inline constexpr auto kNeedsNumber = "a whole number above 0 is needed here"_sentence;
inline constexpr auto kNeedsList = "a list is needed here"_sentence;
inline constexpr auto kNeedsLevels = "a list of levels is needed here"_sentence;
inline constexpr auto kNoShard = "--shard: \"{}\" is no shard; 1/8 to 8/8 are, for example."_sentence;
inline constexpr auto kNeedsOut = "--shard and --merge need --out: there the shards meet."_sentence;
inline constexpr auto kHolds = "\"{}\" holds {} of the {} attempts of this study: run the shards that are missing."_sentence;
inline constexpr auto kOneAttempt = "A study of laws is one attempt: --shard, --merge and --set are for studies over many."_sentence;
inline constexpr auto kPlainName = "A name without folders is needed here: --out says where."_sentence;
inline constexpr auto kSameLaw = "Two laws are called \"{}\"."_sentence;
inline constexpr auto kFewLaws = "At least two laws are needed here: the others are compared with the first."_sentence;
inline constexpr auto kAttemptOrLesson = "Either an attempt or a lesson is needed here, not both."_sentence;
inline constexpr auto kNoDevice = "The recorded attempt has no device of this name."_sentence;
inline constexpr auto kOtherVersions =
    "The hand was recorded with other versions of plugins: from step {} on the scene is not the one that it acted in."_sentence;

// swage audit
inline constexpr auto kNotPlayed = "cannot be played: {}"_sentence;
inline constexpr auto kTooSlow = "too slow: stopped at {} s of the lesson after {} s of processor time"_sentence;
inline constexpr auto kNotOpened = "A device did not open."_sentence;
inline constexpr auto kInstead = "{} {} instead of {}"_sentence;  // a metric, its value, that of the finest level
inline constexpr auto kOtherEnd = "{}, {} {}"_sentence;           // how it ended, a level, how that ended
inline constexpr auto kOwnNotEnough = "**the lesson's level is not enough**: {}"_sentence;
inline constexpr auto kWouldDo = "{} would do and costs {} % more"_sentence;
inline constexpr auto kNoRecord = "\"{}\" is no record of an audit; without --add it is written anew."_sentence;
inline constexpr auto kNoSeries = "There is no series of lessons here; looked in: {}"_sentence;
inline constexpr auto kNameLessons = "Name lesson files, or say --series for those that come with Swage."_sentence;
inline constexpr auto kAddNeedsOut = "--add needs --out: the folder of the audit to which lessons are added."_sentence;
inline constexpr auto kNoLadder = "\"{}\" has no such ladder as --only names."_sentence;

// swage describe, words, needle and bench
inline constexpr auto kNoPluginIn = "{} holds no plugin that can be described."_sentence;
inline constexpr auto kNeither = "Neither a lesson file, nor a bundle, nor the id of a plugin."_sentence;
inline constexpr auto kNoLibrary = "The library of needles is not here. Looked in {}."_sentence;
inline constexpr auto kNoNeedle = "The library has no needle \"{}\".{} It has {}."_sentence;  // second: "did you mean"
inline constexpr auto kBenchKnows = "swage bench knows {}, not \"{}\".{}"_sentence;            // third: "did you mean"
inline constexpr auto kNoBench =
    "The program swage-bench is not beside this one ({}). It measures Swage against its peers and is part of a developer build, not of an "
    "installation: in the sources, scripts/setup.sh build test peer && scripts/build.sh dev swage-bench, then build/dev/bin/swage bench {}."_sentence;

// swage new
inline constexpr auto kNoTemplate = "\"{}\" is no template; there are {}.{}"_sentence;  // third: "did you mean"
inline constexpr auto kNoId = "\"{}\" is not an id. Write a reverse domain in lower case, with _ inside words: org.example.clip"_sentence;
inline constexpr auto kOwnDomain = "Ids that begin with \"swage.\" are those of Swage itself. Take a domain of your own: org.example.{}"_sentence;
inline constexpr auto kNoClass = "\"{}\" cannot name a class. Write letters and digits, the first one large: FineClip"_sentence;
inline constexpr auto kTemplateGone = "The template of a new {} is not installed. Searched: {}. Install Swage's SDK again."_sentence;
inline constexpr auto kNotEmpty = "{} is there already and not empty. Choose another folder with --dir."_sentence;
inline constexpr auto kNoPlace = "{} cannot be written. Choose a folder that you may write to with --dir."_sentence;

// swage doctor: findings and remedies
inline constexpr auto kWithoutWindow = "no display: lessons run without a window"_sentence;
inline constexpr auto kStartDesktop = "Start it from a desktop, or under xvfb-run."_sentence;
inline constexpr auto kWillBeMade = "{} will be made with the first attempt"_sentence;
inline constexpr auto kNotYours = "{} cannot be made: {} is not yours to write"_sentence;
inline constexpr auto kOtherPlace = "Choose another place with --store, or make that folder yours."_sentence;
inline constexpr auto kCheckServer = "Check the server's address, and that it runs and lets you in."_sentence;
inline constexpr auto kRefused = "{} is refused. {}"_sentence;
inline constexpr auto kRebuild = "Rebuild it against this version of Swage, or take it out of the folder."_sentence;
inline constexpr auto kHidden = "{} ({}) is hidden by {}"_sentence;
inline constexpr auto kTakeOneOut = "Take one of the two out of its folder."_sentence;
inline constexpr auto kMayBeRealTime = "the step may run with SCHED_FIFO"_sentence;
inline constexpr auto kNotRealTime = "SCHED_FIFO is not permitted ({}): under load some steps will come milliseconds late"_sentence;
inline constexpr auto kPermitRealTime =
    "Add the line  \"@audio - rtprio 80\"  to /etc/security/limits.d/swage.conf, join that group and log in again."_sentence;
inline constexpr auto kMayBeLocked = "memory may be locked"_sentence;
inline constexpr auto kLittleLocked = "only {} kB may be locked: a page that is not there costs a step"_sentence;
inline constexpr auto kPermitLocking =
    "Add the line  \"@audio - memlock unlimited\"  to /etc/security/limits.d/swage.conf and log in again."_sentence;
inline constexpr auto kOneProcessor = "one processor: the window and the step share it"_sentence;
inline constexpr auto kMoreProcessors = "Use a machine with two or more, or run lessons with --headless."_sentence;
inline constexpr auto kNoOpenGl = "no OpenGL: the window opens without the 3D view"_sentence;
inline constexpr auto kBadOpenGl = "the OpenGL driver crashes or hangs"_sentence;
inline constexpr auto kInstallOpenGl =
    "Install the packages libegl1 and libgl1-mesa-dri (Debian); they also draw without a graphics card."_sentence;
inline constexpr auto kHasConsole = "swage-console is installed"_sentence;
inline constexpr auto kLacksConsole = "swage-console is not beside this program: lessons run without a window"_sentence;
inline constexpr auto kBuildConsole = "Build with -DSWAGE_CONSOLE=ON (it needs Qt6 with Qt3D)."_sentence;
inline constexpr auto kRestoreServer = "Restore the newest backup of that database."_sentence;
inline constexpr auto kSalvage = "Put a new one in its place with: swage attempts salvage --store {}"_sentence;
inline constexpr auto kAttemptsIn = "{} attempts in {}"_sentence;
inline constexpr auto kReadOnly = "{}, which can only be read here: no attempt can be kept"_sentence;  // after the last
inline constexpr auto kOnServer = "the store is on a server"_sentence;
inline constexpr auto kNotAsked = "{} cannot be asked"_sentence;
inline constexpr auto kFree = "{} GB free for attempts"_sentence;
inline constexpr auto kMakeRoom = "Free space on the disk of {}, or choose another with --store."_sentence;
inline constexpr auto kNoHardware = "It needs no hardware of its own."_sentence;
inline constexpr auto kSeeItsPage = "Its page in the documentation says how it is set up."_sentence;
inline constexpr auto kNeverOpens = "it does not come back from open()"_sentence;
inline constexpr auto kEndsProcess = "it ends the process in which it is opened"_sentence;
inline constexpr auto kUnplug = "Unplug what it drives, and tell its author."_sentence;
inline constexpr auto kOpensSilently = "It could not be opened"_sentence;
inline constexpr auto kReady = "ready"_sentence;
inline constexpr auto kReadyAnd = "ready. {}"_sentence;

// swage validate
inline constexpr auto kNoTest = "There is no test \"{}\".{} It has: {}."_sentence;  // second: "did you mean"
inline constexpr auto kNeedsStrictness = "The test \"{}\" needs --strictness {}."_sentence;
inline constexpr auto kNotAskedYet = "not asked: {}. --strictness {} asks these too."_sentence;
inline constexpr auto kNotOfItsKind = "Nothing was tested: \"{}\" is a test of {}."_sentence;
inline constexpr auto kNoLibraryIn = "{} is a bundle without a library (*.so): build it first."_sentence;
inline constexpr auto kHoldsNeither = "{} holds neither a plugin (*.so) nor lessons (*.json)."_sentence;
inline constexpr auto kSeed = " Seed: {}."_sentence;
inline constexpr auto kParameters = " Parameters: {}"_sentence;

// the tests of a plugin that steps
inline constexpr auto kLateHere = "{} That depends on this machine."_sentence;
inline constexpr auto kStepTakes = "A step of its scene takes {} ms, p99 {} ms, worst {} ms."_sentence;
inline constexpr auto kEnergy = "Its energy grew by {} J until step {}, with nothing that touches it."_sentence;
inline constexpr auto kSubnormal = "A private double has become subnormal: arithmetic with it is a hundred times slower."_sentence;
inline constexpr auto kNotRestored = "The saved state cannot be restored."_sentence;
inline constexpr auto kRewinds =
    "After restoring the state of step {} the same 50 steps gave another result: it keeps something that changes outside of its declared state."_sentence;
inline constexpr auto kTwoRuns = "Two runs of the same scene differ at step {}."_sentence;
inline constexpr auto kNotAlone =
    "It moves otherwise at step {} when another instance is in the scene: instances share something that changes."_sentence;
inline constexpr auto kLessonPlaces = "The lesson says where things stand."_sentence;
inline constexpr auto kFrames = "Body \"{}\" ends {} m elsewhere when the scene stands 0.1 m away: a frame is mixed up."_sentence;
inline constexpr auto kHandsOff = "No hand leads anything here."_sentence;
inline constexpr auto kNoScene = "{} is no lesson that can be used: {}"_sentence;
inline constexpr auto kOwnThread = "It is asked on a thread of its own: see the test \"driver\"."_sentence;
inline constexpr auto kWorldNotFinite = "A number of the world is not finite in step {}."_sentence;

// the scene that a plugin is tested in
inline constexpr auto kNeedsParams = "It has required parameters: say --with and a lesson file that uses it."_sentence;
inline constexpr auto kLessonWithout = "The lesson {} does not use it."_sentence;
inline constexpr auto kLessonNotBuilt = "The lesson {} cannot be built. {}"_sentence;
inline constexpr auto kNoObject = "No object is installed."_sentence;
inline constexpr auto kNoPair = "No two installed objects can be bound by it with their defaults. Say --plugin-dir, where its partners are, or --with and a lesson file that uses it. {}"_sentence;
inline constexpr auto kNoCast = "No cast of installed objects makes a scene for it. Say --plugin-dir, where its objects are, or --with and a lesson file that uses it. {}"_sentence;
inline constexpr auto kRefusedSilently = "It was refused without a reason."_sentence;

// faults of lessons and couplings with fuzz values
inline constexpr auto kInStep = "{} {} in step {}."_sentence;  // a plugin, what it did
inline constexpr auto kScore = "gave a score of {}; it goes from 0 to 100"_sentence;
inline constexpr auto kFailedSilently = "failed an attempt without a reason"_sentence;
inline constexpr auto kUndeclared = "said {} {}; it has declared {}"_sentence;
inline constexpr auto kSaidNotFinite = "said a number that is not finite for {} {}"_sentence;
inline constexpr auto kContact = "left a contact with friction {}, stiffness {} N/m, restitution {}"_sentence;
inline constexpr auto kSignalNotFinite = "wrote a signal that is not finite"_sentence;
inline constexpr auto kTooMany = "gave {} {} where there is room for {}"_sentence;  // ties
inline constexpr auto kTiePlace = "gave a tie with a place or axis that is none"_sentence;
inline constexpr auto kTieForce = "gave a tie with a force of the step before that is not finite"_sentence;
inline constexpr auto kTieBody = "gave a tie to a body that is not there"_sentence;
inline constexpr auto kTieStiffness = "gave a tie with a stiffness or strength of {}"_sentence;
inline constexpr auto kMainThread = "called the host {} times from the step with what belongs on the main thread"_sentence;
inline constexpr auto kDoesMore = "It does more than look."_sentence;
inline constexpr auto kAllocates = "It allocated memory {} times in {} steps; nothing on [rt] may."_sentence;
inline constexpr auto kForgets = "After a reset it says other things about the same steps: it remembers what reset() must forget."_sentence;
inline constexpr auto kShares = "A second instance says other things about the same steps: it depends on more than it is shown."_sentence;
inline constexpr auto kRemembers =
    "After restoring its state it says other things about the same steps: it remembers something outside of its declared state."_sentence;
inline constexpr auto kPoisoned = "A number that is not finite stays in it after a reset."_sentence;

// faults of solvers
inline constexpr auto kOtherBits = "{}() gives other bits when it is asked the same again."_sentence;
inline constexpr auto kUnwritten = "mobility() for {} points leaves a number unwritten, or writes one that is not finite."_sentence;
inline constexpr auto kSkew = "mobility() is not symmetric: entries differ by {} of {} m/s per N s."_sentence;
inline constexpr auto kPulls =
    "mobility() is not positive semi-definite: an eigenvalue is {} of {} m/s per N s. Pushing would give energy."_sentence;
inline constexpr auto kPart = "mobility() of some points differs when more points are asked for."_sentence;
inline constexpr auto kSurfaceUnwritten = "displacement() leaves a number unwritten, or writes one that is not finite."_sentence;
inline constexpr auto kBandNoChain = "It offers {} without a chain."_sentence;
inline constexpr auto kBandMobility = "linearise() gives another mobility than mobility() does."_sentence;
inline constexpr auto kBandFree = "linearise() leads elsewhere than v_free of mobility() says."_sentence;
inline constexpr auto kBandNotFinite = "linearise() gives a number that is not finite."_sentence;
inline constexpr auto kDisplaceNotFinite = "displace() leaves a vertex that is not finite."_sentence;
inline constexpr auto kDisplaceOff = "After displace() the vertices do not stand where the change leads from where advance() left them."_sentence;
inline constexpr auto kDisplaceSpeed = "After displace() the velocities do not lead from where the step began to where the vertices stand."_sentence;
inline constexpr auto kBandNotDefinite = "linearise() gives no positive definite matrix, however often it is asked for a stiffer one."_sentence;
inline constexpr auto kImpulsesNotFinite = "apply_impulses() leaves a speed that is not finite."_sentence;
inline constexpr auto kNotCompared = "Motion after impulses was not compared: its surface does not move with its bodies."_sentence;
inline constexpr auto kImpulsesOff = "After apply_impulses() the points do not move as v_free + W j says: {} m/s off, of a change of {} m/s."_sentence;
inline constexpr auto kImpulsesSlip = "After apply_impulses() without impulses the points do not move as v_free says: {} m/s off."_sentence;

// what is drawn beside shapes
inline constexpr auto kManyVisuals = "draw() writes {} primitives where there is room for {}"_sentence;
inline constexpr auto kVisualBeyond = "draw() writes beyond the {} primitives that there is room for"_sentence;
inline constexpr auto kOfVisual = "draw(): primitive {} ({}) {}"_sentence;  // from 0, its kind, one of the next
inline constexpr auto kVisualKind = "is of kind {}, which nobody knows"_sentence;
inline constexpr auto kVisualTone = "has the tone {}, which nobody knows"_sentence;
inline constexpr auto kVisualBody = "is on body {}, and its object has {}"_sentence;
inline constexpr auto kVisualNumber = "has a {} that is not finite, or beyond 1e6 m"_sentence;  // member: "a.z"
inline constexpr auto kVisualSize = "has a radius of {} m"_sentence;
inline constexpr auto kVisualStrength = "has a strength of {}; it goes from 0 to 1"_sentence;
inline constexpr auto kVisualNormal = "has a normal of length {}; a normal is unit"_sentence;
inline constexpr auto kVisualUnseen = "draw(): primitive {} ({}) is seen only on objects with the trait {}"_sentence;
inline constexpr auto kVisualsLeftOut = "draw() has {} primitives, and the host has room for {}: the others are not drawn"_sentence;
inline constexpr auto kDrawsNothing = "It draws nothing beside its shapes."_sentence;
inline constexpr auto kVisualMeddles = "draw() changes the scene; it may only look"_sentence;
inline constexpr auto kVisualOther = "draw() gives other bits when it is asked the same again"_sentence;

// of a solver, once more
inline constexpr auto kNoSolver = "It has no solver of its own."_sentence;

// faults of traits
inline constexpr auto kGaps = "The table of {} has gaps."_sentence;
inline constexpr auto kOfCall = "{}() {}"_sentence;  // one of the next
inline constexpr auto kPlaceRange = "gives a place s outside of 0 to 1."_sentence;
inline constexpr auto kNotSquare = "gives a tangent and a normal that are not unit and square to each other."_sentence;
inline constexpr auto kPlaceNoNumber = "gives a place that is no number."_sentence;
inline constexpr auto kNoLength = "gives no length > 0 m."_sentence;
inline constexpr auto kNoLengthRadius = "gives no length and radius > 0 m."_sentence;
inline constexpr auto kNoJaw = "names a jaw that it has not declared."_sentence;
inline constexpr auto kAxis = "gives an axis that is not unit."_sentence;
inline constexpr auto kGripper = "gives tips, an opening or a closure that are none."_sentence;
inline constexpr auto kTangent = "gives a tangent that is not unit."_sentence;
inline constexpr auto kNormal = "gives a normal that is not unit."_sentence;
inline constexpr auto kProperty = "gives a property that is negative or no number."_sentence;
inline constexpr auto kFewNodes = "gives fewer than two nodes: a strand has two ends."_sentence;
inline constexpr auto kNodesAlone = "It tells how many nodes it has, but has no trait {} that says where it is."_sentence;
inline constexpr auto kLineAlone = "It tells all its places at once, but has no trait {} that tells one of them."_sentence;
inline constexpr auto kLineFails = "fails for two places or more."_sentence;
inline constexpr auto kBeyond = "writes beyond the places that were asked for."_sentence;
inline constexpr auto kOtherPlaces = "gives other places than place() does."_sentence;
inline constexpr auto kStrand = "gives no length and radius > 0 m, or a strength that is negative or no number."_sentence;
inline constexpr auto kElsewhere = "gives a place elsewhere than at s."_sentence;
inline constexpr auto kStrandRange = "gives a place s outside of 0 to the length."_sentence;
inline constexpr auto kTension = "gives a place or a tension that is no number."_sentence;
inline constexpr auto kShear = "gives blades a force that is negative or no number."_sentence;
inline constexpr auto kCutFails = "fails within the strand's length."_sentence;
inline constexpr auto kStaysWhole = "leaves the strand whole where it was cut."_sentence;
inline constexpr auto kNoStrand = "It can be cut, but has no trait {} that says how long it is."_sentence;
inline constexpr auto kNoFunctions = "Its traits have no functions."_sentence;
inline constexpr auto kNoBody = "names a body that it has not declared."_sentence;

// faults of devices that observe the scene
inline constexpr auto kNoSight = "It does not see the scene."_sentence;
inline constexpr auto kSeesOtherwise = "A second instance that sees the same scene answers otherwise: it depends on more than it is shown."_sentence;

// faults of drivers
inline constexpr auto kInfinite = "What it tells of itself is infinite."_sentence;
inline constexpr auto kUnknownFlags = "It has unknown flags ({})."_sentence;
inline constexpr auto kNoRate = "Its rate of {} Hz is none."_sentence;
inline constexpr auto kForces = "It {} forces, and bears {} N."_sentence;  // "takes", "takes no"
inline constexpr auto kOpensNot = "open() refuses and does not say why."_sentence;
inline constexpr auto kDidNotOpen = "It did not open: {}"_sentence;
inline constexpr auto kTableGaps = "The table {} has gaps."_sentence;
inline constexpr auto kCalibrationNoJson = "The text of its calibration is no JSON object."_sentence;
inline constexpr auto kSentNothing = "It opened and sent no measurement. What is connected to it?"_sentence;
inline constexpr auto kSlowExchange = "An exchange took {} s; after {} s without a sample the hand counts as lost."_sentence;
inline constexpr auto kTooSlowExchange =
    "An exchange took {} s. Wait for a driver for 0.1 s at most, and say that nothing new came."_sentence;
inline constexpr auto kCallsHost = "It called the host from a thread that may not."_sentence;
inline constexpr auto kSampleNotFinite = "A sample has a number that is not finite."_sentence;
inline constexpr auto kUnknownFields = "A sample says that unknown fields are valid ({})."_sentence;
inline constexpr auto kBackwards = "The number of the measurements goes backwards."_sentence;
inline constexpr auto kQuaternion = "A valid pose has a quaternion of length {}."_sentence;
inline constexpr auto kClosure = "A valid closure is {}; it goes from 0 open to 1 closed."_sentence;
inline constexpr auto kOlder = "A newer measurement has an older time."_sentence;
inline constexpr auto kOtherClock = "The time of its measurements is not on the host's clock (CLOCK_MONOTONIC, s)."_sentence;
inline constexpr auto kExchange = " Exchange {}."_sentence;
inline constexpr auto kInTheStep = "It is asked in the step, as the other tests do."_sentence;
inline constexpr auto kMeasurements = "{} measurements; the longest exchange took {} ms."_sentence;

// swage replay
inline constexpr auto kIdentical = "identical {} steps ({} s)"_sentence;
inline constexpr auto kDiffers = "differs from step {} on ({} s)"_sentence;

// swage pull
inline constexpr auto kPulledKnot = "knot {} in \"{}\", loop {}, friction {}"_sentence;
inline constexpr auto kBeingPulled = "pulling the knot: {} of {}"_sentence;
inline constexpr auto kKnotHolds = "holds {}; slip {}"_sentence;
inline constexpr auto kKnotSlips = "gives way: it has borne {}; slip {}"_sentence;
inline constexpr auto kKnotBroke = "the thread parts: it has borne {}; slip {}"_sentence;
inline constexpr auto kNoSuchMoment = "The attempt ends at {} s."_sentence;

// swage calibrate: the command line; messages of sensors and fits are in sensor/sentences.hpp
inline constexpr auto kSayWho = "Say who calibrates, with --by."_sentence;
inline constexpr auto kWhoseTable = "Say whose table this is: the sensor's serial number with --serial."_sentence;
inline constexpr auto kCannotName = "\"{}\" cannot name a file. Give a serial number of letters, digits, - _ and . with --serial."_sentence;
inline constexpr auto kTypedNoNumber = "That is no number."_sentence;
inline constexpr auto kNobodyAnswers = "Nobody answers."_sentence;
inline constexpr auto kNobodyKeeps = "Nobody answers; nothing is kept."_sentence;
inline constexpr auto kNothingKept = " Nothing is kept."_sentence;  // after why
inline constexpr auto kRowOf = "{}, line {}: a row has {} numbers."_sentence;
inline constexpr auto kNoRow = "{}: It has no row of numbers."_sentence;
inline constexpr auto kOfTable = "{}: {}"_sentence;

// and of the sensor
inline constexpr auto kSaysNotWho = "{} does not say who it is. Is it a sensor that speaks JAW1, and powered?"_sentence;
inline constexpr auto kSlope = "{} mm/V, {} mm at 0 V"_sentence;
inline constexpr auto kTipForces = "{} N at the tips by the calibration, {} N by the gauge"_sentence;
inline constexpr auto kPosesMoved = "all poses moved by {} mm"_sentence;
inline constexpr auto kVoltsFirst = "Its volts have no meaning yet. First: swage calibrate displacement."_sentence;
inline constexpr auto kTravelFirst = "Its travel has no force yet. First: swage calibrate force."_sentence;
inline constexpr auto kNoneKept = "No calibration is kept in {}"_sentence;

}  // namespace swage::tools::say
