#pragma once

#include "gui/session/look.h"
#include "gui/session/workplace.h"

#include <array>
#include <memory>

namespace luxdeck::gui {

/// Makes pictures visible in the background: of many wishes in a row, the newest counts. What was developed stays until
/// the next is ready.
class Darkroom {
public:
    static constexpr std::size_t kSides = 2;  ///< left and right of a divider
    using Pictures = std::array<std::shared_ptr<const Image>, kSides>;

    explicit Darkroom(Workplace& place) : place_(place) {}

    /// pictures  null: nothing on that side
    void develop(const Pictures& pictures, const Look& look);
    /// What there is to see; null: nothing. The last that became ready: maybe not yet of the newest wish.
    [[nodiscard]] const std::shared_ptr<const Developed>& shown(std::size_t side) const { return shown_[side]; }
    /// The picture that it was made of.
    [[nodiscard]] const std::shared_ptr<const Image>& source(std::size_t side) const { return sources_[side]; }
    void clear();

private:
    struct Wish {
        Pictures pictures;
        Look look;
    };
    void start();

    Workplace& place_;
    Wish wish_;
    bool busy_ = false, fresh_ = false;  // a job runs; the wish is newer than that job's
    Pictures sources_;
    std::array<std::shared_ptr<const Developed>, kSides> shown_;
};

}  // namespace luxdeck::gui
