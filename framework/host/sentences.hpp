// SPDX-License-Identifier: Apache-2.0
//
// Messages of this room about parameters, declarations of plugins, and libraries that cannot be loaded. Tests refer to their names and
// never repeat their words.
#pragma once

#include "base/sentence.hpp"

namespace swage::host::say {

using base::operator""_sentence;

// parameter values
inline constexpr auto kParamsNoJson = "The parameters are not JSON: {}"_sentence;
inline constexpr auto kParamsNoObject = "\"params\" is an object { \"name\": value, ... }, not {}."_sentence;
inline constexpr auto kParamsLeft = "And {} more parameters have not been looked at."_sentence;
inline constexpr auto kNeedsParam = "{} needs \"{}\" ({}): {}"_sentence;  // plugin, id, expected type, its doc
inline constexpr auto kNoSuchParam = "{} has no such parameter.{}{}"_sentence;  // plugin, "did you mean", list of its parameters
inline constexpr auto kHas = " It has: {}."_sentence;
inline constexpr auto kHasNone = " It has none."_sentence;
inline constexpr auto kFormerName = "\"{}\" is now called \"{}\". Write  \"{}\": {}"_sentence;
inline constexpr auto kGivenTwice = "\"{}\" is given twice."_sentence;
inline constexpr auto kOtherType = "\"{}\" is {}, not {}."_sentence;  // label, expected type, given value
inline constexpr auto kOutOfRange = "{} is out of range; \"{}\" goes from {} to {}."_sentence;
inline constexpr auto kNoFile = "\"{}\": there is no file {}."_sentence;
inline constexpr auto kBadFile = "\"{}\", {}: {}"_sentence;

// types of parameters
inline constexpr auto kWhole = "a whole number"_sentence;
inline constexpr auto kFlag = "true or false"_sentence;
inline constexpr auto kOneOf = "one of {}"_sentence;
inline constexpr auto kText = "a text"_sentence;
inline constexpr auto kFileName = "the name of a file"_sentence;
inline constexpr auto kNumbers = "a list of {} numbers{}"_sentence;
inline constexpr auto kNumber = "a number"_sentence;

// a number with a unit
inline constexpr auto kNotAUnit = "\"{}\" is not a unit ({})."_sentence;
inline constexpr auto kNotANumber = "\"{}\" is not a number with a unit; \"{}\" is {}."_sentence;
inline constexpr auto kHasNoUnit = "\"{}\" has no unit; \"{}\" is {}."_sentence;
inline constexpr auto kUnknownUnit = "\"{}\": \"{}\" is not a unit; \"{}\" is {}."_sentence;
inline constexpr auto kOtherDimension = "\"{}\" is {}; \"{}\" is {}."_sentence;  // "a force", then a label and its expected type
inline constexpr auto kTooLargeNumber = "\"{}\" is too large to be a number."_sentence;

// a table of parameters
inline constexpr auto kOfParam = "Parameter \"{}\": {}"_sentence;
inline constexpr auto kNotSnakeCase = "the id is not snake_case."_sentence;
inline constexpr auto kIdTwice = "the id is there twice."_sentence;
inline constexpr auto kAliasTwice = "the alias \"{}\" is there twice."_sentence;
inline constexpr auto kNoLabel = "it has no label."_sentence;
inline constexpr auto kNoDoc = "it has no doc."_sentence;
inline constexpr auto kNoSuchType = "type {} is unknown."_sentence;
inline constexpr auto kNoSiUnit = "unit \"{}\" is not an SI unit of the table ({})."_sentence;
inline constexpr auto kOtherDisplayUnit = "display unit \"{}\" does not measure what \"{}\" does."_sentence;
inline constexpr auto kEmptyRange = "min is greater than max."_sentence;
inline constexpr auto kDefaultOutOfRange = "the default is out of range."_sentence;
inline constexpr auto kDefaultNotWhole = "the default is no integer."_sentence;
inline constexpr auto kDimension = "dimension must be {}."_sentence;
inline constexpr auto kNoChoices = "it has no choices."_sentence;
inline constexpr auto kDefaultNoChoice = "the default is not a choice."_sentence;

// any declaration
inline constexpr auto kHasNo = "{} has no {}."_sentence;  // "A lesson", "bodies"
inline constexpr auto kNoRoom = "The scene would have {} {}; there is room for {}."_sentence;
inline constexpr auto kNotDeclared = "{} is fixed to body {}, which was not declared."_sentence;
inline constexpr auto kUnknownFlags = "A shape has unknown flags ({})."_sentence;
inline constexpr auto kManyPoints = "An object may be asked about at most {} contact points at once, not {}."_sentence;
inline constexpr auto kNotDotted = "\"{}\" is not a name such as \"grasp.force\"."_sentence;
inline constexpr auto kNameNoDoc = "\"{}\" has no doc."_sentence;
inline constexpr auto kNameNoUnit = "\"{}\": \"{}\" is not an SI unit of the table ({})."_sentence;
inline constexpr auto kDeclaredTwice = "\"{}\" is declared twice."_sentence;
inline constexpr auto kUnknownWhat = "declare() does not know what {} is."_sentence;
inline constexpr auto kGaps = "The table {} of {} has gaps."_sentence;
inline constexpr auto kNotOffered = "{} does not offer {}."_sentence;
inline constexpr auto kLargeState = "state() of {} numbers is too large."_sentence;

// bodies, particles and hinges
inline constexpr auto kOfBody = "Body \"{}\": {}"_sentence;
inline constexpr auto kStartPose = "the start pose is not a position and a unit quaternion."_sentence;
inline constexpr auto kMotion = "motion {} is unknown."_sentence;
inline constexpr auto kNoMassHere = "only dynamic bodies have a mass."_sentence;
inline constexpr auto kNeedsMass = "a dynamic body needs a mass > 0 kg."_sentence;
inline constexpr auto kNeedsInertia = "a dynamic body needs moments of inertia > 0 kg m2."_sentence;
inline constexpr auto kNoSuchInertia = "no body has these moments of inertia: one exceeds the sum of the others."_sentence;
inline constexpr auto kNoHinge = "Body \"{}\" is hinged, but no hinge names it as its child."_sentence;
inline constexpr auto kParticles = "particles() needs positions, masses and a radius >= 0 m."_sentence;
inline constexpr auto kParticle = "Particle {}: its position must be finite and its mass > 0 kg."_sentence;
inline constexpr auto kNullHinge = "hinge() needs a hinge."_sentence;
inline constexpr auto kOfHinge = "The hinge of body \"{}\"{}"_sentence;
inline constexpr auto kChildNotHinged = ": the child must be declared as hinged."_sentence;
inline constexpr auto kHingeTwice = " is there twice."_sentence;
inline constexpr auto kChildBeforeParent = ": the parent must be declared before the child."_sentence;
inline constexpr auto kHingeAxis = " needs an anchor and a unit axis."_sentence;
inline constexpr auto kHingeInertia = " needs an inertia > 0 kg m2."_sentence;
inline constexpr auto kHingeAngles = ": angle 0 is the start pose, so min <= 0 <= max and min < max."_sentence;

// shapes
inline constexpr auto kSphere = "A sphere needs a centre and a radius > 0 m."_sentence;
inline constexpr auto kTube = "{} needs two different ends and a radius > 0 m."_sentence;
inline constexpr auto kArcPose = "An arc needs a pose: a position and a unit quaternion."_sentence;
inline constexpr auto kArcRadius = "An arc needs 0 < wire radius < radius."_sentence;
inline constexpr auto kArcSweep = "An arc needs a sweep between 0 and 2 pi rad."_sentence;
inline constexpr auto kConvexNothing = "A convex polyhedron needs vertices and faces."_sentence;
inline constexpr auto kConvexMany = "A convex polyhedron has at most {} vertices and as many faces."_sentence;
inline constexpr auto kConvexVertex = "A convex polyhedron has a vertex that is not finite."_sentence;
inline constexpr auto kConvexFaces = "A convex polyhedron has faces that do not follow each other in face_start."_sentence;
inline constexpr auto kConvexRefused = "A convex polyhedron is refused: {}."_sentence;
inline constexpr auto kFieldPose = "A height field needs a pose: a position and a unit quaternion."_sentence;
inline constexpr auto kFieldCount = "A height field has 2 to {} vertices along x and y."_sentence;
inline constexpr auto kFieldCells = "A height field needs sides of its cells > 0 m and a reach below its surface > 0 m."_sentence;
inline constexpr auto kFieldHeights = "A height field needs finite heights."_sentence;
inline constexpr auto kFieldState = "A height field names private doubles for its heights that were not declared."_sentence;
inline constexpr auto kChainKind = "A chain has pieces of kind 1, straight ones, or is of kind 2, spheres."_sentence;
inline constexpr auto kChainCount = "A chain has 2 to {} vertices, not {}."_sentence;
inline constexpr auto kChainNothing = "A chain needs vertices and radii."_sentence;
inline constexpr auto kOfVertex = "Vertex {} of a chain{}"_sentence;
inline constexpr auto kVertexNotFinite = " is not finite."_sentence;
inline constexpr auto kVertexTwice = " is where the one before it is."_sentence;
inline constexpr auto kVertexArc = " has an arc length that is not finite or not above the one before it."_sentence;
inline constexpr auto kPieceRadius = "Piece {} of a chain needs a radius >= 0 m."_sentence;
inline constexpr auto kChainBend = "A chain needs a least radius of curvature > 0 m."_sentence;
inline constexpr auto kChainState = "A chain names {} private doubles that were not declared."_sentence;
inline constexpr auto kChainBody = "A chain is on a body that its object moves itself."_sentence;

// loading a library
inline constexpr auto kOtherAbi = "It was built for plugin interface {}; this program offers {}. {}"_sentence;
inline constexpr auto kNewerAbi = "Update this program, or build the plugin for an older interface."_sentence;
inline constexpr auto kOtherMajor = "Build it against this program's SDK."_sentence;
inline constexpr auto kLoadThrew = "It threw an exception while it was loaded."_sentence;
inline constexpr auto kLoaderRefused = "The dynamic loader refused it: {}."_sentence;
inline constexpr auto kLoadLocale = "It changes the language of the program (setlocale) when it is loaded."_sentence;
inline constexpr auto kLoadRounding =
    "It changes how the processor calculates when it is loaded (linked with -ffast-math?). Link it without."_sentence;
inline constexpr auto kNoPlugin = "It is not a Swage plugin: it exports no {}."_sentence;
inline constexpr auto kInitLocale = "Its init changes the language of the program (setlocale)."_sentence;
inline constexpr auto kInitRounding = "Its init changes how the processor calculates."_sentence;
inline constexpr auto kIncomplete = "Its {} is incomplete."_sentence;
inline constexpr auto kInitFailed = "Its init failed."_sentence;
inline constexpr auto kNoFactory = "It offers no {}."_sentence;
inline constexpr auto kNotDescribed = "It could not be described: {} does not run."_sentence;
inline constexpr auto kLoadEndless = "It did not finish loading within {} s."_sentence;
inline constexpr auto kLoadCrashed = "It crashed while it was loaded: {}."_sentence;
inline constexpr auto kLoadEnded = "It ended the program in which it was loaded, without a word."_sentence;
inline constexpr auto kUnusable = "\"{}\" ({}) cannot be used. {}"_sentence;
inline constexpr auto kNotInstalled = "\"{}\" is not installed."_sentence;
inline constexpr auto kNearest = " Nearest: \"{}\" {}."_sentence;
inline constexpr auto kSearched = " Searched: {}."_sentence;
inline constexpr auto kPlugins = " ({} plugins)"_sentence;
inline constexpr auto kAbsent = " (absent)"_sentence;
inline constexpr auto kRefused = " Refused: {}."_sentence;

// descriptors of a library
inline constexpr auto kNullDescriptor = "Its descriptor {} of {} is NULL."_sentence;
inline constexpr auto kHoldsNone = "It holds no plugin."_sentence;
inline constexpr auto kDescribeThrew = "It threw an exception while it was described."_sentence;
inline constexpr auto kDescribeDid = "It {} while it was described."_sentence;
inline constexpr auto kOtherFile = "It is not a {} file: {}"_sentence;
inline constexpr auto kNoId = "Id \"{}\" is not a reverse domain in lower case such as \"org.example.clip\"."_sentence;
inline constexpr auto kNoVersion = "Version \"{}\" is not three numbers such as \"1.2.0\"."_sentence;
inline constexpr auto kNoKind = "Kind {} is not object, coupling, device or lesson."_sentence;
inline constexpr auto kNoCueRole = "Cue \"{}\" has the role {}; a role is 0 (neutral), 1 (good), 2 (warning), 3 (bad) or 4 (target)."_sentence;
inline constexpr auto kTraitsOfObjects = "Only objects offer traits."_sentence;
inline constexpr auto kHasNoText = "It has no {}."_sentence;
inline constexpr auto kControl = "{} says something with control characters."_sentence;

// files of rating scales
inline constexpr auto kScaleFormat = "The format of a scale is \"{}\"."_sentence;
inline constexpr auto kNoKey = "{} has no \"{}\"."_sentence;
inline constexpr auto kOtherKind = "\"{}\" of {} is not {}."_sentence;  // text, an object, a list
inline constexpr auto kEmptyKey = "\"{}\" of {} is empty."_sentence;
inline constexpr auto kNoNumberKey = "{} has no number \"{}\"."_sentence;
inline constexpr auto kIsNoObject = "{} is not an object."_sentence;
inline constexpr auto kUnknownKey = "{} has an unknown key \"{}\"."_sentence;
inline constexpr auto kUnlikeUnits = "\"best\" and \"worst\" of {} have different units."_sentence;
inline constexpr auto kSameEnds = "\"best\" and \"worst\" of {} are the same."_sentence;
inline constexpr auto kSameScale = "The scale \"{}\" is there already: another id is needed."_sentence;
inline constexpr auto kIsNoFlag = "\"{}\" of {} is neither true nor false."_sentence;
inline constexpr auto kNotBelow = "\"lowest_points\" is not below \"highest_points\"."_sentence;
inline constexpr auto kNeedsIsNoList = "\"needs\" of the scale is no list of metrics."_sentence;
inline constexpr auto kSameItem = "Two items are called \"{}\"."_sentence;
inline constexpr auto kNoItems = "The scale has no items."_sentence;

// quarantine

inline constexpr auto kQuarantine = "{} ({} {}) {} in {}() at step {} and is in quarantine."_sentence;

// end of a plugin's test
inline constexpr auto kNoProcess = "No process could be started for it."_sentence;
inline constexpr auto kNotDone = "It was not done within {} s{}."_sentence;
inline constexpr auto kCrashed = "It crashed{}: {}."_sentence;
inline constexpr auto kEndedIn = "It ended its process{}."_sentence;
inline constexpr auto kEndedWith = "It ended its process with code {}."_sentence;
inline constexpr auto kNotLoaded = "The library cannot be loaded."_sentence;

// findings of the tests of a plugin
inline constexpr auto kNoElf = "It is no 64-bit ELF library."_sentence;
inline constexpr auto kExportsMore = "It exports more than {}: {}."_sentence;
inline constexpr auto kLoadsTwo = "Loading it twice gives two libraries."_sentence;
inline constexpr auto kSlowLoad = "Loading took {} ms of processor time; 100 ms is much."_sentence;
inline constexpr auto kCreatesAnything = "create(\"{}\") must answer NULL: there is no such plugin here."_sentence;
inline constexpr auto kTableOfNobody = "The table of parameters of an unknown id must be NULL with a count of 0."_sentence;
inline constexpr auto kAnyFactory = "get_factory of an unknown factory must answer NULL."_sentence;
inline constexpr auto kSameId = "The id \"{}\" is there twice."_sentence;
inline constexpr auto kAnyDescriptor = "descriptor() beyond the count must answer NULL."_sentence;
inline constexpr auto kNoPluginJson = "There is no plugin.json beside it; each start has to ask the library itself."_sentence;
inline constexpr auto kOldPluginJson = "plugin.json beside it was made from another binary; run swage-describe again."_sentence;
inline constexpr auto kOwnDefault = "{}: its own default is refused: {}"_sentence;
inline constexpr auto kEarlyActivate = "{} lets itself be activated before it was configured."_sentence;
inline constexpr auto kAnyExtension = "{}: get_extension of an unknown id must answer NULL."_sentence;
inline constexpr auto kRefusesDefaults = "{} refuses its own defaults and does not say why."_sentence;
inline constexpr auto kConfiguresOnce = "{} cannot be configured a second time."_sentence;
inline constexpr auto kTraitNotOffered = "{} lists the trait \"{}\" and does not offer it."_sentence;
inline constexpr auto kActivates = "{} cannot be activated the {}. time: {}"_sentence;
inline constexpr auto kWrongThread = "{} called the host {} times from a thread that may not: text in the step, or random numbers outside of it."_sentence;
inline constexpr auto kRewinds = "{} gives other results after a rewind: it remembers something outside of its state."_sentence;
inline constexpr auto kSecondInstance = "{} gives other results in a second instance: it depends on more than parameters and state."_sentence;
inline constexpr auto kAtEnd = "\"{}\" at {}"_sentence;  // where the finding was made: at min, at max
inline constexpr auto kRefusesSilently = "{}: {} refuses without a reason."_sentence;
inline constexpr auto kNoCount = "This program does not count allocations."_sentence;
inline constexpr auto kAllocates = "{} allocated memory {} times in {} steps; nothing on [rt] may."_sentence;

// files of translations
inline constexpr auto kWordsNoJson = "These translations are not used: the file is not JSON."_sentence;
inline constexpr auto kWordsFormat = "These translations are not used: the format is not \"{}\"."_sentence;
inline constexpr auto kWordsLanguage = "These translations are not used: the language is not \"{}\", as the file is called."_sentence;
inline constexpr auto kWordsNone = "These translations are not used: there are no \"words\"."_sentence;
inline constexpr auto kTranslation = "The translation of \"{}\" {}."_sentence;
inline constexpr auto kNoTranslation = "has no text"_sentence;
inline constexpr auto kOtherPlaces = "has other places in braces than the words it translates"_sentence;

}  // namespace swage::host::say
