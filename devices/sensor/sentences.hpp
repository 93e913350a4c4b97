// SPDX-License-Identifier: Apache-2.0
//
// Messages of this library about ports, measurements and calibrations. Tests refer to their names and never repeat their words.
#pragma once

#include "toolkit/sentence.hpp"

namespace swage::sensor::say {

using toolkit::operator""_sentence;

// a serial port
inline constexpr auto kNotThere = "{} is not there. Is the sensor plugged in? Its lasting name is below /dev/serial/by-id."_sentence;
inline constexpr auto kMayNotOpen =
    "{} may not be opened. Install the udev rule 70-swage.device.jaw_sensor.rules, or add yourself to the group dialout (sudo adduser $USER dialout) and log in again."_sentence;
inline constexpr auto kBusy = "{} is in use by another program. Close that one, or remove the package modemmanager or brltty."_sentence;
inline constexpr auto kNotOpened = "{} cannot be opened: {}."_sentence;
inline constexpr auto kNoSuchRate = "A port cannot be opened at {} bit/s."_sentence;
inline constexpr auto kNoSerialPort = "{} is no serial port."_sentence;

// measuring
inline constexpr auto kWhichPort = "Name the sensor's port; there are {} serial adapters."_sentence;
inline constexpr auto kBeyondRange = "The sensor is beyond its range, or its cable is off."_sentence;
inline constexpr auto kFewMeasurements = "The sensor sent {} measurements in that time. Is it still plugged in?"_sentence;
inline constexpr auto kMoved = "It moved meanwhile ({} mV). Hold it still and try again."_sentence;
inline constexpr auto kNoFileName = "\"{}\" cannot name a file. A serial number has letters, digits, - _ and ."_sentence;
inline constexpr auto kClosedFirst = "Measure the pose \"just closed\" first: the travel of a force begins there."_sentence;
inline constexpr auto kWhoCalibrates = "Say who calibrates."_sentence;
inline constexpr auto kNoFit = "There is no fit yet."_sentence;

// fit of lengths
inline constexpr auto kFewPoints = "A fit needs {} points or more, 13 over 6 mm are usual; there are {}."_sentence;
inline constexpr auto kNoPoint = "A point is not a number."_sentence;
inline constexpr auto kSameLength = "Two points have the same length, {}."_sentence;
inline constexpr auto kOtherSlope = "The fit gives {} mm/V; this sensor has {} mm/V. Is its range set right?"_sentence;
inline constexpr auto kNoLine = "No {} points in a row lie on a line: the worst is {} off, allowed are {}. Measure again, or look for a loose swivel."_sentence;

// tables of forces
inline constexpr auto kForceCount = "A force table has 2 to 64 points, 5 to 11 are usual; there are {}."_sentence;
inline constexpr auto kForceNoNumber = "A point of the force table is not a number."_sentence;
inline constexpr auto kTravelFalls = "The travel of a force table goes up from point to point; at {} it does not."_sentence;
inline constexpr auto kForceFalls = "The force of a force table never goes down; at {} it does."_sentence;
inline constexpr auto kTipCount = "A table of forces has 5 to 11 points; there are {}."_sentence;
inline constexpr auto kTipFalls = "The force at the tips goes up with that at the handle; at {} N it does not."_sentence;
inline constexpr auto kTipOff = "{} N at the tips are measured as {} N, {} % off; allowed are {} %. Measure the forces anew."_sentence;
inline constexpr auto kPressesNothing = "A force at the handle below what closes it presses nothing; leave that point out."_sentence;

// poses
inline constexpr auto kPoseNoNumber = "A pose is not a number."_sentence;
inline constexpr auto kSamePoses = "Open and just closed are the same to {}. Is the sensor held in its swivels?"_sentence;
inline constexpr auto kSqueezedBack = "Squeezed must go on from just closed, away from open: open {}, closed {}, squeezed {}."_sentence;
inline constexpr auto kOtherHolder = "The ways differ by more than a fifth from those of before ({} and {}; now {} and {}). Is it the same needleholder?"_sentence;
inline constexpr auto kNoPoses = "There are no poses yet whose zero could be set. First: swage calibrate poses."_sentence;
inline constexpr auto kRestsElsewhere =
    "The handle rests {} from where it was open, more than a fifth of its way ({}). Is it let go? Otherwise measure all three poses."_sentence;
inline constexpr auto kReadsLess = "The handle reads {} mm less than open ({} % of its way)."_sentence;
inline constexpr auto kReadsMore = "The handle reads {} mm more than open ({} % of its way)."_sentence;
inline constexpr auto kGaugeReads = "The gauge on the handle reads {} N while the handle is open."_sentence;
inline constexpr auto kSetZero = " If nobody holds it, set its zero: swage calibrate zero, or Setup, Jaw sensors, Calibrate, Poses."_sentence;
inline constexpr auto kNoTriangle = "Swivels at {} and {} from the pivot cannot be {} apart."_sentence;
inline constexpr auto kLongestOpen = "With this geometry the sensor is longest when the handle is open; here it is shortest."_sentence;

// identity and date of a calibration
inline constexpr auto kOtherSensor = "The calibration is that of the sensor {}, and this one is {}."_sentence;
inline constexpr auto kExpired = "The calibration of {} expired on {}. Make a new one: swage calibrate displacement."_sentence;

// calibration files: after the path of the file and a colon
inline constexpr auto kInPart = "In {}: {}"_sentence;  // key of the part, and one of the sentences of this file
inline constexpr auto kNumber = "{}{} must be a number."_sentence;
inline constexpr auto kText = "{} must be a text."_sentence;
inline constexpr auto kObject = "{} must be an object."_sentence;
inline constexpr auto kUnknown = "{} is not known."_sentence;
inline constexpr auto kFormatIs = "Its format must be \"{}\"."_sentence;
inline constexpr auto kList = "{} must be a list."_sentence;
inline constexpr auto kRows = "{} must have rows of {} numbers."_sentence;
inline constexpr auto kMissing = "displacement is missing."_sentence;
inline constexpr auto kNoSlope = "displacement/slope must not be 0."_sentence;
inline constexpr auto kNoDate = "\"{}\" is no date; one is 2026-11-22."_sentence;
inline constexpr auto kNoJson = "It is not JSON."_sentence;
inline constexpr auto kNotWritten = "{} cannot be written: {}."_sentence;

}  // namespace swage::sensor::say
