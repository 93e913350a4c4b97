// SPDX-License-Identifier: Apache-2.0
//
// Messages of this room about stores, attempts, people and stations. Tests refer to their names and never repeat their words.
#pragma once

#include "base/sentence.hpp"

namespace swage::record::say {

using base::operator""_sentence;

// general
inline constexpr auto kNoAttempt = "There is no attempt {} in the store."_sentence;
inline constexpr auto kNoAttemptAtAll = "There is no attempt {}."_sentence;
inline constexpr auto kUnusable = "{} cannot be used as the store of attempts. {}{}"_sentence;
inline constexpr auto kForeign = "{} cannot be used. {}{}"_sentence;
inline constexpr auto kOtherDatabase = "{} is a database, but not one of Swage attempts."_sentence;
inline constexpr auto kNoStoreFile = "{} is not a file of Swage attempts (its first bytes are not those of an SQLite file).{}"_sentence;
inline constexpr auto kUnreadable = "{} cannot be read: {}.{}"_sentence;
inline constexpr auto kNewerTables = "It was written by a newer Swage (tables of version {}, this program knows {}): update Swage."_sentence;
inline constexpr auto kNoUpgrade = "Its tables cannot be made or upgraded: {}."_sentence;
inline constexpr auto kNotCompared = "Its tables cannot be compared with those of Swage: {}"_sentence;
inline constexpr auto kNoTableList = "Its list of tables cannot be read: {}."_sentence;
inline constexpr auto kOtherTable = "Its {} \"{}\" is not as Swage makes it."_sentence;
inline constexpr auto kStrangeTable = "It holds a {} that Swage does not make."_sentence;

// remedies
inline constexpr auto kRestoreBackup = " Restore its newest backup."_sentence;
inline constexpr auto kSalvageIt = " If it was a store, \"swage attempts salvage --store {}\" makes a new one of what can still be read."_sentence;
inline constexpr auto kFreeSpace = " Free space on that disk, or raise the limit on the size of files (ulimit -f)."_sentence;
inline constexpr auto kOtherStore = " Choose another store with --store."_sentence;
inline constexpr auto kCheckServer = " Check that the server runs and lets this station in."_sentence;

// connection
inline constexpr auto kNoStoreKind =
    "\"{}://\" is no store that Swage knows. A store is a file (/folder/attempts.db) or a PostgreSQL database (postgresql://user@host/database)."_sentence;
inline constexpr auto kNotAFile = "{} is not a file: it is a folder, a device or a pipe."_sentence;
inline constexpr auto kNotOpened = "{} cannot be opened: {}."_sentence;
inline constexpr auto kNoPartOfAddress =
    "{}: \"{}\" is no part of an address that Swage knows; allowed are host, port, user, password, passfile and those that begin with ssl."_sentence;
inline constexpr auto kServerSilent = "the server has not answered for 3 s"_sentence;
inline constexpr auto kNoPages = "{} cannot be read: {}."_sentence;

// recording
inline constexpr auto kFallbackFull = "The fallback file {} is full too: from here on nothing of this attempt is kept. Free space on that disk."_sentence;
inline constexpr auto kStoreFails = "The store {}"_sentence;  // {}: one of the next four
inline constexpr auto kLocked = "is locked by another program"_sentence;
inline constexpr auto kDiskFull = "cannot grow: the disk is full, or files may not be that large (ulimit -f)"_sentence;
inline constexpr auto kNoAnswer = "does not answer ({})"_sentence;
inline constexpr auto kNotWritten = "cannot be written ({})"_sentence;
inline constexpr auto kGoesOn = "{}. The attempt goes on and is kept in {}; it is merged when the store is next opened.{}"_sentence;
inline constexpr auto kFreeSpaceNow = " Free space on that disk now: the file has room for a minute or two."_sentence;
inline constexpr auto kNothingKept =
    "{}, and no file can be written beside it: from here on nothing of this attempt is kept. Free space there or choose another store."_sentence;
inline constexpr auto kAttemptNotKept = "This attempt is not kept. {}"_sentence;
inline constexpr auto kStepsLost = "{} steps of this attempt could not be kept: it can be replayed up to the first of them only."_sentence;
inline constexpr auto kMerged = "The store can be written again: the attempt has been merged into it."_sentence;

// reading of attempts
inline constexpr auto kDamagedTable = "Attempt {} is damaged: its table \"{}\" holds more than Swage ever writes."_sentence;
inline constexpr auto kDamagedHead = "The head of attempt {} is damaged: its plugins, devices or names are not what Swage writes."_sentence;
inline constexpr auto kFileChecksum = "The file \"{}\" of attempt {} does not fit its checksum."_sentence;
inline constexpr auto kTooLong = "Attempt {} is too long to be opened: it has more than {} MB of samples and signals."_sentence;
inline constexpr auto kTooManyDevices = "Attempt {} claims more devices or signals than a scene can have."_sentence;
inline constexpr auto kUnlikeStreams = "The recording of attempt {} is damaged: its streams are not equally long."_sentence;

// transfer between stores
inline constexpr auto kHoldsNoAttempt = "It holds no attempt."_sentence;
inline constexpr auto kHoldsMore = "It holds more than one attempt: it is a store, not an export."_sentence;
inline constexpr auto kStrangeId = "Its attempt has an identifier that Swage does not make."_sentence;
inline constexpr auto kRowsChecksum = "It is damaged: its rows do not fit the checksum that was written with them."_sentence;
inline constexpr auto kNotExported = "Attempt {} cannot be exported to {}. {}"_sentence;
inline constexpr auto kTooLarge = "{} is refused. It is larger than 1 GiB, which no exported attempt is."_sentence;
inline constexpr auto kErased = "Its attempt was erased from this store for good, with the person who made it."_sentence;
inline constexpr auto kNotBackedUp = "{} cannot be backed up to {}. {}"_sentence;
inline constexpr auto kNotRestored = "{} cannot be restored into {}. {}"_sentence;
inline constexpr auto kNothingLeft = "Nothing of Swage's is left in {}."_sentence;
inline constexpr auto kServerNotSalvaged = "A database of a server is not salvaged but restored from its newest backup."_sentence;
inline constexpr auto kThereAlready = "{} is there already: name a file that is not."_sentence;
inline constexpr auto kInUse = "{} is in use: close every Swage program first."_sentence;

// exported files, and the removal of an erased person from them
inline constexpr auto kNoHome =
    "\"{}\" cannot be the home of identifiers: an address such as https://school.example.org, without a slash at its end, is needed."_sentence;
inline constexpr auto kHoldsNothing = "{} holds nothing of this person."_sentence;
inline constexpr auto kTakenOut = "The person was taken out of {}."_sentence;
inline constexpr auto kRowsTakenOut = "The person's rows were taken out of {}."_sentence;
inline constexpr auto kStatementsThere = "The record store {} has statements of the code {}: have them removed there."_sentence;
inline constexpr auto kElsewhere = "{} was written on the station {}: delete it there."_sentence;
inline constexpr auto kFileGone = "{} is no longer there."_sentence;
inline constexpr auto kDeleted = "{} was deleted."_sentence;
inline constexpr auto kNotDeleted = "{} cannot be deleted: {}."_sentence;
inline constexpr auto kNotChanged = "{} cannot be changed: delete it."_sentence;

// people, groups, courses
inline constexpr auto kCodeTaken = "The code \"{}\" is another person's already."_sentence;
inline constexpr auto kPersonGone = "The person is no longer in the store."_sentence;
inline constexpr auto kGroupGone = "The group is no longer in the store."_sentence;
inline constexpr auto kCourseGone = "The course is no longer in the store."_sentence;
inline constexpr auto kHasAttempts = "The person has attempts: archive or erase instead."_sentence;
inline constexpr auto kNobody = "Nobody in the store is called \"{}\"."_sentence;
inline constexpr auto kIsRunning = "An attempt of this person is running: end it first."_sentence;
inline constexpr auto kNeedsGroupName = "A group needs a name."_sentence;
inline constexpr auto kGroupTaken = "A group is called \"{}\" already."_sentence;
inline constexpr auto kBadCourse = "The course \"{}\" cannot be read. {}"_sentence;
inline constexpr auto kNeedsWords = "A note needs some words."_sentence;
inline constexpr auto kNeedsPoints = "A rating needs an item and points."_sentence;
inline constexpr auto kNeedsReason = "Say why: who reads this later must know."_sentence;
inline constexpr auto kNeedsName = "A person needs a name."_sentence;
inline constexpr auto kNoHandedness = "\"{}\" is no handedness; \"left\" and \"right\" are."_sentence;
inline constexpr auto kNameTaken = "Somebody is called \"{}\" already: add what tells the two apart."_sentence;
inline constexpr auto kStillRunning = "Attempt {} is still running."_sentence;
inline constexpr auto kNoGuest = "Attempt {} is no guest's: it belongs to {}."_sentence;
inline constexpr auto kColumn =
    "The column \"{}\" is left out: name, group, hand and code are known, and first name and last name."_sentence;
inline constexpr auto kHeadWithoutName = "Its first line titles columns (\"{}\"...), and none of them is \"name\"."_sentence;
inline constexpr auto kWindowsText = "Line {} is not UTF-8: the list was read as Windows-1252. Check letters such as \u00e4 and \u00e9."_sentence;
inline constexpr auto kOtherText = "Line {} is neither UTF-8 nor Windows-1252: save the table as CSV, UTF-8."_sentence;
inline constexpr auto kManyFields = "It has {} fields, {} are expected."_sentence;
inline constexpr auto kNoName = "It has no name."_sentence;
inline constexpr auto kOfLine = "Line {}: {} Nobody was added."_sentence;
inline constexpr auto kNoSuchRule = "no rule is called \"{}\"; \"streak\" and \"lc-cusum\" are"_sentence;
inline constexpr auto kNeedsTitle = "A course needs a title."_sentence;
inline constexpr auto kOfStep = "Step {} of the course \"{}\": "_sentence;
inline constexpr auto kNeedsLesson = "{}a lesson is needed."_sentence;
inline constexpr auto kNeedsMetric = "{}a limit needs a metric."_sentence;
inline constexpr auto kEmptyLimit = "{}the limit of {} asks for at least more than at most."_sentence;
inline constexpr auto kNoLimit = "{}the limit of {} has no number."_sentence;
inline constexpr auto kNeedsNovice = "A synthetic lesson needs a novice."_sentence;
inline constexpr auto kSchoolNeedsLesson = "A synthetic school needs a lesson."_sentence;
inline constexpr auto kSchoolNeedsPeople = "A synthetic school needs people and attempts."_sentence;
inline constexpr auto kSyntheticAlready = "{} holds a synthetic school already."_sentence;

// stations
inline constexpr auto kManyStations = "There are {} stations called \"{}\": give this one another name with --station."_sentence;
inline constexpr auto kNothingRuns = "No attempt runs at {}."_sentence;
inline constexpr auto kNotRecorded = "The attempt at {} is not recorded: there is nothing to pin a mark to."_sentence;
inline constexpr auto kKeptThere = "The attempt at {} is kept at the station itself for now: mark it in Review once it has come in."_sentence;

}  // namespace swage::record::say
