#include "gui/session/darkroom.h"

#include <utility>

namespace luxdeck::gui {

void Darkroom::develop(const Pictures& pictures, const Look& look) {
    wish_ = {pictures, look};
    fresh_ = true;
    if (!busy_) start();
}

void Darkroom::start() {
    busy_ = true, fresh_ = false;
    place_.jobs.start(JobKind::Look, "Developing", [this, wish = wish_](const Progress&, const Jobs::Tell&) -> Jobs::Delivery {
        std::array<std::shared_ptr<const Developed>, kSides> made;
        std::optional<Error> failed;
        for (std::size_t side = 0; side < kSides; ++side) {
            if (!wish.pictures[side]) continue;
            auto developed = gui::develop(*wish.pictures[side], wish.look);
            if (developed) made[side] = std::make_shared<const Developed>(*std::move(developed));
            else failed = developed.error();
        }
        return [this, made, failed, pictures = wish.pictures] {
            busy_ = false;
            if (failed) place_.complain(*failed);
            // What is no longer wished for is not shown either.
            else if (wish_.pictures[0] || wish_.pictures[1]) shown_ = made, sources_ = pictures;
            if (fresh_) start();
            place_.tell(Change::Pictures);
        };
    });
}

void Darkroom::clear() {
    wish_ = {};
    busy_ = fresh_ = false;
    shown_ = {}, sources_ = {};
}

}  // namespace luxdeck::gui
