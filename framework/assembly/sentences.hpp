// SPDX-License-Identifier: Apache-2.0
//
// Messages of this room about lesson files. Tests refer to their names and never repeat their words.
#pragma once

#include "base/sentence.hpp"
#include "host/sentences.hpp"

namespace swage::assembly::say {

using base::operator""_sentence;

// the text of a file
inline constexpr auto kNoFile = "There is no such lesson file."_sentence;
inline constexpr auto kTooLarge = "It is larger than 4 MiB; that is no lesson."_sentence;
inline constexpr auto kEmpty = "It is empty; the smallest lesson is { \"format\": \"swage-lesson/1\", ... }."_sentence;
inline constexpr auto kTooDeep = "Its brackets are nested deeper than 32."_sentence;
inline constexpr auto kNotJson =
    "This is not valid JSON at column {}: a comma, colon, quotation mark or bracket is missing or too many."_sentence;
inline constexpr auto kLargeNumber = "It holds a number that is too large."_sentence;
inline constexpr auto kTooMuch = "It holds more than 20 000 values, or a key of more than 200 letters; that is no lesson."_sentence;
inline constexpr auto kTwice = "\"{}\" is there twice."_sentence;
inline constexpr auto kControl = "\"{}\" holds a control character, which no text of a lesson needs."_sentence;
inline constexpr auto kLongText = "It is longer than 10 000 bytes."_sentence;
inline constexpr auto kMore = "And {} more."_sentence;

// variants
inline constexpr auto kBaseIsNoText = "\"based_on\" names the lesson file of which this one is a variant."_sentence;
inline constexpr auto kBaseIsItself = "It is based on itself, by way of \"{}\"."_sentence;
inline constexpr auto kTooManyBases = "More than eight lessons are based on one another."_sentence;
inline constexpr auto kNoBase = "There is no lesson file \"{}\" to be based on."_sentence;
inline constexpr auto kBadBase = "\"{}\" is no lesson to be based on. {}"_sentence;
inline constexpr auto kNothingToSetIn = "It is not a JSON object, so nothing can be set in it."_sentence;
inline constexpr auto kNotOwn = "\"{}\" is missing: a lesson has its own, whatever it is based on."_sentence;
inline constexpr auto kFromBase =
    "\"{}\" comes from the lesson that this one is based on. To change a value write \"set\": { \"needle.arc\": \"2/8\" }; to add "
    "or leave out a part write \"add\" or \"remove\"; for all else write the whole lesson."_sentence;
inline constexpr auto kRemoveIsNoList = "\"remove\" is a list of parts' names [ \"floor\", ... ]."_sentence;
inline constexpr auto kAddIsNoObject = "\"add\" is an object of lists { \"objects\": [ ... ], \"couplings\": [ ... ], \"devices\": [ ... ] }."_sentence;
inline constexpr auto kNobodyToRemove = "There is no \"{}\" to remove.{} There is: {}."_sentence;  // second {}: "did you mean"
inline constexpr auto kSetIsNoObject = "\"set\" is an object { \"needle.arc\": \"2/8\", ... }."_sentence;
inline constexpr auto kNoPart = "\"{}\" is no value of a part; it looks like \"needle.arc\"."_sentence;
inline constexpr auto kNoParams = "\"{}\" cannot be set: the lesson that this one is based on has no \"params\": { ... } there."_sentence;
inline constexpr auto kNobodyToSet = "There is no \"{}\" to set \"{}\".{} There is: {}."_sentence;  // third {}: "did you mean"

// values of a file
inline constexpr auto kNoObject = "This is {}: an object { \"name\": value, ... }, not {}."_sentence;
inline constexpr auto kNoMedium = "\"medium\" is missing: dry, moist or water; on the command line --set environment.medium=dry beside it."_sentence;
inline constexpr auto kMissing = "\"{}\" is missing."_sentence;
inline constexpr auto kNoText = "\"{}\" is a text, not {}."_sentence;
inline constexpr auto kEmptyText = "\"{}\" is empty."_sentence;
inline constexpr auto kNoFlag = "\"{}\" is true or false, not {}."_sentence;
inline constexpr auto kNoChoice = "\"{}\" is not known for \"{}\".{} There is: {}."_sentence;
inline constexpr auto kNoName = "\"{}\" is not a name: lower-case letters, digits and _, a letter first."_sentence;
inline constexpr auto kNoQuantity = "\"{}\" is {}, not {}."_sentence;
inline constexpr auto kUnits = " ({})"_sentence;  // list of the admissible units
using host::say::kOutOfRange;
inline constexpr auto kNoWhole = "\"{}\" is a whole number from 0, not {}."_sentence;
inline constexpr auto kNoVector = "\"{}\" is a list of 3 numbers, not {}."_sentence;
inline constexpr auto kNoCharge = "In \"{}\" surroundings a thread keeps no charge: set \"charge\" to 0, or \"medium\" to \"dry\"."_sentence;
inline constexpr auto kTooLargeNumber = "{} is too large."_sentence;
inline constexpr auto kTwoRotations = "A pose has \"q\" or \"rpy\", not both."_sentence;
inline constexpr auto kNoQuaternion = "\"q\" is a unit quaternion [w, x, y, z], not {}."_sentence;
inline constexpr auto kNoList = "\"{}\" is a list [ ... ], not {}."_sentence;
inline constexpr auto kTooMany = "\"{}\" has at most {} entries, not {}."_sentence;
inline constexpr auto kUnknownKey = "\"{}\" is not known in {}.{} It has: {}."_sentence;
inline constexpr auto kMoreKeys = "And {} more keys are not known."_sentence;

// keys of a lesson
inline constexpr auto kLongLabel = "The words of a button have at most {} characters."_sentence;
inline constexpr auto kOtherFormat = "\"{}\" cannot be read; this program reads \"{}\"."_sentence;
inline constexpr auto kNoChannel = "{} is no channel of cues; there is colour, shape, sound, force."_sentence;
inline constexpr auto kNoRequirements = "\"requires\" is an object { \"plugin.id\": \"^1\", ... }."_sentence;
inline constexpr auto kNoVersions =
    "{} is not a range of versions; write \"^1.2\" (1.2 or later, below 2), \">=1.2\" or \"1.2.0\" (exactly)."_sentence;
inline constexpr auto kNoPair = "\"between\" holds the names of two objects, [\"a\", \"b\"], not {}."_sentence;
inline constexpr auto kTaken = "\"{}\" is taken: every device, object and coupling has its own name."_sentence;
inline constexpr auto kNoSuch = "The lesson has no {} \"{}\".{}{}"_sentence;  // then "did you mean", and the list of names
using host::say::kHas;
using host::say::kHasNone;
inline constexpr auto kNoClutch = "A button of a clutch is a whole number from 0 to 31, not {}."_sentence;
inline constexpr auto kNoButtons = "\"clutch_of\" needs \"clutch\", the buttons of that device."_sentence;
inline constexpr auto kNoPoint = "A point is the force in the scene and that at the hand, [\"20 mN\", \"0.1 N\"], not {}."_sentence;
inline constexpr auto kFallingTable = "A table begins at [0, 0], and its forces rise from point to point."_sentence;
inline constexpr auto kShortTable = "A reaction by table needs \"table\", at least two points."_sentence;
inline constexpr auto kTableOfNoLaw = "\"table\" belongs to the law \"table\"."_sentence;
inline constexpr auto kNoForce = "The law \"{}\" needs \"from\", a force above 0 N."_sentence;

// plugins
inline constexpr auto kNoMode = "There is no mode \"{}\". There is: practice, test, demo."_sentence;
inline constexpr auto kOtherKind = "\"{}\" is a plugin of kind {}; this place takes kind {}."_sentence;
inline constexpr auto kOtherVersion = "\"{}\" {} is installed; this lesson requires {}."_sentence;
inline constexpr auto kUnused = "Nothing in this lesson uses \"{}\"."_sentence;
inline constexpr auto kNotRequired = "This lesson uses \"{}\". Add to \"requires\":  \"{}\": \"^{}\""_sentence;
inline constexpr auto kRefusedParams = "{} refused these parameters without a reason."_sentence;
inline constexpr auto kManyObjects = "A lesson has at most {} objects, not {}."_sentence;
inline constexpr auto kManyDevices = "A lesson has at most {} devices, not {}."_sentence;
inline constexpr auto kNoSolver = "Body \"{}\" moves itself, but {} does not offer {} nor {}."_sentence;

// devices
inline constexpr auto kNoDevices = "This lesson has no device; \"{}\" is not used."_sentence;
inline constexpr auto kNoDevice = "There is no device \"{}\" for this lesson.{} There is: {}."_sentence;
inline constexpr auto kReplaced = "\"{}\" is not installed; \"{}\" uses \"{}\"."_sentence;
inline constexpr auto kFollowsNobody = "\"{}\" follows a hand; say which:  \"follows\": { \"pose\": \"{}\", \"closure\": \"{}\" }"_sentence;

// couplings and their objects
inline constexpr auto kNoTrait = "\"{}\" needs the trait \"{}\" here; \"{}\" ({}) does not offer it. {}"_sentence;
inline constexpr auto kNobodyOffers = "No object of this lesson does."_sentence;
inline constexpr auto kOthersOffer = "Those of this lesson that do: {}."_sentence;
inline constexpr auto kNobodyFinds =
    "\"{}\" looks at the contacts between \"{}\" and \"{}\", but nothing in this lesson finds them; add a coupling that does, such as "
    "\"swage.coupling.contact\"."_sentence;
inline constexpr auto kOtherOrder = "Another coupling finds these contacts as [\"{}\", \"{}\"]; name the two in the same order in both."_sentence;
inline constexpr auto kRefusedPair = "\"{}\" refused to join \"{}\" and \"{}\" without a reason."_sentence;
inline constexpr auto kRefusedScene = "\"{}\" refused this scene without a reason."_sentence;
inline constexpr auto kRefusedSight = "\"{}\" refused to look at this scene without a reason."_sentence;

// marks of a lesson
inline constexpr auto kNullMark = "mark() needs a mark."_sentence;
inline constexpr auto kManyMarks = "A lesson has at most {} marks."_sentence;
inline constexpr auto kMarkMeaning = "A mark needs a meaning such as \"region.target\"."_sentence;
inline constexpr auto kPointMark = "A mark of a point needs a place and a radius > 0 m."_sentence;
inline constexpr auto kMarkKind = "Mark kind {} is unknown."_sentence;
inline constexpr auto kMarkOfNobody = "A mark names object {}, which is not there."_sentence;
inline constexpr auto kArcMarkRange = "A mark of an arc goes from a share to a larger one, both in 0..1."_sentence;
inline constexpr auto kArcMarkOf = "A mark of an arc names \"{}\", which has none."_sentence;

}  // namespace swage::assembly::say
