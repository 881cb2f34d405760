#pragma once

#include "analysis/compare/error_statistics.h"
#include "engine/core/progress.h"
#include "engine/io/project.h"
#include "engine/transport/lit_scene.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace luxdeck {

/// What one measurement of a subject gave.
struct Measured {
    Field values;                 // [lx] of grids, [cd/m^2] of pictures
    double seconds = 0;
    std::uint64_t paths = 0;
    std::uint64_t rejected = 0;   // samples that were not finite or negative
    bool whole = true;            // false: cancelled on the way, and not to be used
};

/// Where one number of a subject lies.
struct Place {
    std::string grid;             // of a point of a grid; empty: a pixel
    Vec3d position{0, 0, 0};      // of a point [m], user coordinates
    int column = 0, row = 0;      // of a grid (0, 0 at its origin) or a picture (at its top left)
};

/// Something that algorithms are compared on: all points of the project's grids, or a small picture of a view.
class Subject {
public:
    virtual ~Subject() = default;

    /// "grids", or the view's name.
    [[nodiscard]] virtual const std::string& name() const = 0;
    [[nodiscard]] virtual bool isPicture() const { return false; }
    [[nodiscard]] virtual std::size_t size() const = 0;
    /// The scale that errors are told relative to: the value itself, where it is dark kDarkPoint of its grid's (picture's)
    /// mean.
    [[nodiscard]] virtual Field scaleOf(const Field& truth) const = 0;
    [[nodiscard]] virtual Place placeOf(std::size_t index) const = 0;
    /// Names where and how values are measured: references are kept by it.
    [[nodiscard]] virtual std::string key() const = 0;
    /// Sample numbers are multiples of this.
    [[nodiscard]] virtual std::uint32_t leastSamples() const = 0;

    /// `samples` paths for each point or pixel. The bits depend on estimator, samples and seed alone.
    [[nodiscard]] virtual Measured measure(const RadianceEstimator& estimator, std::uint32_t samples, std::uint64_t seed,
                                           const std::string& stage, const Progress& progress) const = 0;
};

/// All points of all calculation grids.
///
/// errors  InvalidArgument: a grid that cannot be laid out
Result<std::unique_ptr<Subject>> gridsSubject(const Project& project);

/// A picture of a view, so many pixels high, as wide as the view's shape asks.
///
/// all outlive the subject
std::unique_ptr<Subject> viewSubject(const Project& project, const LitScene& lit, const View& view, int height);

/// The size of such a picture.
View shrunk(const View& view, int height);

}  // namespace luxdeck
