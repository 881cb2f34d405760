#include "gui/session/furnishing.h"

#include "gui/session/edits.h"
#include "gui/session/furnishing_room.h"
#include "gui/session/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace luxdeck::gui {

/// All that follows a hand: each part is used by the next.
struct Furnishing::Live {
    std::shared_ptr<const LitProject> shown;  // with the object
    EmptyRoom room;
    MovableObject object;
    std::unique_ptr<FurnitureLighting> lighting;

    static Result<std::shared_ptr<Live>> make(const std::shared_ptr<const LitProject>& shown, const std::string& name, const std::vector<VolumeState>& known,
                                              const std::optional<VolumeRequest>& request, const Progress& progress) {
        auto live = std::make_shared<Live>();
        live->shown = shown;
        auto object = makeMovableObject(shown->project.scene, name);
        if (!object) return object.error();
        live->object = *std::move(object);
        auto room = emptyRoom(*shown, name, known, request, progress);
        if (!room) return room.error();
        live->room = *std::move(room);
        auto lighting = live->newLighting();
        if (!lighting) return lighting.error();
        live->lighting = *std::move(lighting);
        return live;
    }

    /// A job has one of its own: a lighting is of one thread.
    [[nodiscard]] Result<std::unique_ptr<FurnitureLighting>> newLighting() const {
        return FurnitureLighting::create(object, *room.volume, &room.project->lit.raycaster());
    }
};

void Furnishing::begin(const std::string& object) {
    request_.reset();
    object_ = object, requirementKnown_ = false;
    prepare();
}

void Furnishing::begin(const std::string& object, const VolumeRequest& volume) {
    request_ = volume;
    object_ = object, requirementKnown_ = false;
    prepare();
}

void Furnishing::letGo() {
    place_.jobs.cancel(preparing_);
    place_.jobs.cancel(asking_);
    state_ = State::Idle;
    live_.reset(), of_.reset(), roomChange_.reset();
    pose_ = {}, light_ = {};
}

void Furnishing::prepare() {
    letGo();
    if (!place_.project) return;
    state_ = State::Preparing;
    of_ = place_.project;
    preparing_ = place_.jobs.start(JobKind::Furniture, "Preparing " + object_,
                                   [this, of = of_, object = object_, known = volumes_.all(), request = request_](const Progress& progress, const Jobs::Tell&) -> Jobs::Delivery {
        auto made = std::make_shared<Result<std::shared_ptr<Live>>>(Live::make(of, object, known, request, progress));
        return [this, made, of, object] {
            if (of_ != of || object_ != object || state_ != State::Preparing) return;
            if (*made) return ready(**made);
            if (made->error().code != ErrorCode::Cancelled) place_.complain(made->error());
            cancel();
        };
    });
    place_.tell(Change::Jobs);
    place_.tell(Change::Furniture);
}

void Furnishing::ready(std::shared_ptr<Live> live) {
    live_ = std::move(live);
    state_ = State::Ready;
    for (const auto& warning : live_->object.warnings) place_.warn(warning);
    if (live_->room.built) volumes_.add({"without " + object_, {}, live_->room.volume, live_->room.project, object_, true});
    if (!requirementKnown_) {
        const auto required = requiredOn(live_->shown->project, live_->object);
        requirement_ = {};
        requiredBy_ = required ? required->grid : "";
        if (required) requirement_.meanAtLeast = required->meanLux;
        requirementKnown_ = true;  // it goes with the object, wherever that is put down
    }
    relight();
}

void Furnishing::relight() {
    live_->lighting->update(pose_);
    light_ = live_->lighting->workingSurface(requirement_);
    place_.tell(Change::Furniture);
}

void Furnishing::cancel() {
    if (state_ == State::Idle && object_.empty()) return;
    letGo();
    object_.clear();
    place_.tell(Change::Furniture);
}

Result<void> Furnishing::commit(Session& session) {
    if (!live_ || pose_ == Pose{}) return {};
    return session.edit("Move " + object_, edits::moveObject(live_->shown, object_, pose_));
}

Vec3d Furnishing::pivot() const { return live_ ? live_->object.pivot + live_->shown->project.scene.origin : Vec3d(0, 0, 0); }

void Furnishing::moveTo(const Pose& pose) {
    if (!live_ || pose == pose_) return;
    pose_ = pose;
    relight();
}

const FurnitureLighting* Furnishing::lighting() const { return live_ ? live_->lighting.get() : nullptr; }

void Furnishing::setRequirement(const LightRequirement& requirement) {
    requirement_ = requirement, requiredBy_.clear(), requirementKnown_ = true;
    if (live_) relight();
}

std::string Furnishing::sentence(const Units& units) const {
    const auto lux = [&](const Interval& i) { return fmt::format("{} {}", intervalText(units.illuminance(i.value), units.illuminance(i.ci95)), units.illuminanceUnit()); };
    if (live_->object.workingSurfaceM2 == 0) return fmt::format("{}: has no working surface", object_);
    if (light_.unknownPart >= 1) return fmt::format("{}: nothing is known of its light here: it stands in something, or outside the volume", object_);
    const auto& r = requirement_;
    switch (light_.verdict) {
        case FurnitureVerdict::Under: return fmt::format("{}: too little light: {}, {} required", object_, lux(light_.mean), units.illuminanceText(*r.meanAtLeast));
        case FurnitureVerdict::Over: return fmt::format("{}: too much light: up to {}, at most {} allowed", object_, lux(light_.maximum), units.illuminanceText(*r.limit));
        case FurnitureVerdict::Undecided:
            return r.meanAtLeast ? fmt::format("{}: too close to tell: {}, {} required", object_, lux(light_.mean), units.illuminanceText(*r.meanAtLeast))
                                 : fmt::format("{}: too close to tell: up to {}, at most {} allowed", object_, lux(light_.maximum), units.illuminanceText(*r.limit));
        case FurnitureVerdict::Met: return fmt::format("{}: {}: requirement met", object_, lux(light_.mean));
        case FurnitureVerdict::None: break;
    }
    return fmt::format("{}: {}", object_, lux(light_.mean));
}

std::string Furnishing::statement(const Units& units) const { return live_ ? sentence(units) : ""; }

std::string Furnishing::warning(const Units& units) const {
    if (!live_ || live_->object.workingSurfaceM2 == 0) return "";
    const bool good = light_.unknownPart < 1 && (light_.verdict == FurnitureVerdict::None || light_.verdict == FurnitureVerdict::Met);
    return good ? "" : sentence(units);
}

RoomChange& Furnishing::changeAt(const Pose& pose) {
    if (!roomChange_ || roomChange_->pose != pose) roomChange_ = RoomChange{pose, {}, nullptr};
    return *roomChange_;
}

void Furnishing::estimateRoom() {
    if (!live_) return;
    place_.jobs.cancel(asking_);
    asking_ = place_.jobs.start(JobKind::Furniture, "What " + object_ + " takes from the room", [this, live = live_, pose = pose_](const Progress& progress, const Jobs::Tell&) -> Jobs::Delivery {
        auto lighting = live->newLighting();
        if (!lighting) return place_.complaint(lighting.error());
        if (progress.cancelled()) return {};
        (*lighting)->update(pose);
        auto taken = estimateTaken(live->room.project->project, live->room.project->lit, **lighting);
        if (!taken) return place_.complaint(taken.error());
        return [this, live, pose, grids = *std::move(taken)] {
            if (live != live_) return;
            changeAt(pose).estimated = grids;
            place_.tell(Change::Furniture);
        };
    });
    place_.tell(Change::Jobs);
}

void Furnishing::solveRoom(const SolveSettings& settings) {
    if (!live_) return;
    place_.jobs.cancel(asking_);
    asking_ = place_.jobs.start(JobKind::Furniture, "Solving the room without and with " + object_,
                                [this, live = live_, pose = pose_, settings](const Progress& progress, const Jobs::Tell&) -> Jobs::Delivery {
        const auto& room = *live->room.project;
        auto furnished = withObjectAt(room.project.scene, live->shown->project.scene, live->object.name, live->object, pose);
        auto solved = solveTaken(room.project, room.lit, std::move(furnished), settings, progress);
        if (!solved) return place_.complaint(solved.error());
        return [this, live, pose, exact = std::make_shared<const ExactTaken>(*std::move(solved))] {
            if (live != live_) return;
            changeAt(pose).exact = exact;
            place_.tell(Change::Furniture);
        };
    });
    place_.tell(Change::Jobs);
}

void Furnishing::follow() {
    if (object_.empty() || of_ == place_.project || !place_.project) return;
    const auto& objects = place_.project->project.scene.objects;
    const bool there = std::any_of(objects.begin(), objects.end(), [&](const SceneObject& each) { return each.name == object_; });
    if (there) prepare();
    else cancel();
}

void Furnishing::clear() {
    letGo();
    object_.clear(), request_.reset();
    requirement_ = {}, requiredBy_.clear(), requirementKnown_ = false;
    place_.tell(Change::Furniture);
}

}  // namespace luxdeck::gui
