#pragma once

#include "analysis/compare/comparison.h"
#include "analysis/compare/subject.h"

namespace luxdeck {

/// The figures of a run from its errors.
void enterErrors(const RunErrors& errors, ComparedRun& run);

/// Worst values and error maps of an algorithm's largest run.
///
/// repetitions  #K x N
void addPlaces(const Subject& subject, const ReferenceFields& reference, const std::string& algorithm, const std::vector<Field>& repetitions, Comparison& comparison);

/// One map for each grid, or one for the picture; free points are one row.
///
/// errors  #V  (value - reference) / scale
std::vector<ErrorMap> mapsOf(const Subject& subject, const std::string& algorithm, const Field& errors);

/// #V  (value - truth) / scale
Field relativeErrors(const ReferenceFields& reference, const Field& values);

/// The mean of some fields of one size, at least one.
Field meanOf(const std::vector<Field>& repetitions);

/// The grids of a subject and their points; nothing of a picture.
void addGrids(const Subject& subject, Comparison& comparison);

/// What a reader must know beside the figures: references that missed what was asked for, runs that are below them, biases that
/// the registry does not claim.
void addWarnings(Comparison& comparison);

}  // namespace luxdeck
