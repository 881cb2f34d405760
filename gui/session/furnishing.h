#pragma once

#include "analysis/furniture/furniture_lighting.h"
#include "analysis/furniture/taken_light.h"
#include "gui/session/units.h"
#include "gui/session/volumes.h"
#include "gui/session/workplace.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace luxdeck::gui {

class Session;

/// What the object takes from the room's calculation surfaces at one pose.
struct RoomChange {
    Pose pose;
    std::vector<GridTaken> estimated;             ///< first order; empty: not asked for
    std::shared_ptr<const ExactTaken> exact;      ///< null: not asked for
};

/// A piece of furniture that is moved while its light follows (Change::Furniture whenever something of it changes).
///
///     session.furnishing.begin("Desk 03");          // prepared in the background: once a room, some seconds to a minute
///     ... until state() == State::Ready
///     session.furnishing.moveTo(pose);  // at each move of the hand: ~3 ms
///     session.furnishing.commit(session);           // or cancel()
///
/// While an object is in hand, views draw lighting()->object() at lighting()->placement() with lighting()->lux(), instead of the
/// scene's. Volumes of rooms without it are put into Volumes and found there again.
class Furnishing {
public:
    enum class State { Idle, Preparing, Ready };

    Furnishing(Workplace& place, Volumes& volumes) : place_(place), volumes_(volumes) {}

    /// Takes an object in hand. The volume is as the project's [[volume]] says, or as `volume` does.
    void begin(const std::string& object);
    void begin(const std::string& object, const VolumeRequest& volume);
    /// Puts it back where it was.
    void cancel();
    /// Leaves it where it is now, in the project; it stays in hand. errors  of Session::edit()
    Result<void> commit(Session& session);

    [[nodiscard]] State state() const { return state_; }
    /// Empty: none.
    [[nodiscard]] const std::string& object() const { return object_; }
    /// From where the project has it.
    [[nodiscard]] const Pose& pose() const { return pose_; }
    /// Where the project has its pivot [m, user coordinates].
    [[nodiscard]] Vec3d pivot() const;
    void moveTo(const Pose& pose);

    /// Null: not ready.
    [[nodiscard]] const FurnitureLighting* lighting() const;
    [[nodiscard]] const WorkingSurfaceLight& light() const { return light_; }
    /// Of the calculation surface that lay over it when it was taken in hand, where there is one; or what was set.
    [[nodiscard]] const LightRequirement& requirement() const { return requirement_; }
    /// Where the requirement is from: the surface's name; empty: it was set, or there is none.
    [[nodiscard]] const std::string& requiredBy() const { return requiredBy_; }
    void setRequirement(const LightRequirement& requirement);

    /// "Desk 03: 612 ± 14 lx, 500 lx required: met"; empty: not ready.
    [[nodiscard]] std::string statement(const Units& units) const;
    /// The same where something is wrong; empty: nothing is.
    [[nodiscard]] std::string warning(const Units& units) const;

    /// In the background, at the pose as it is now: what it takes from the room. The exact one solves the room twice.
    void estimateRoom();
    void solveRoom(const SolveSettings& settings);
    [[nodiscard]] const std::optional<RoomChange>& roomChange() const { return roomChange_; }
    /// The room's change is of the present pose.
    [[nodiscard]] bool roomChangeCurrent() const { return roomChange_ && roomChange_->pose == pose_; }

    /// The project has changed: what is in hand is taken up again in the new one, where it still is.
    void follow();
    void clear();

private:
    struct Live;

    void prepare();
    void ready(std::shared_ptr<Live> live);
    void letGo();
    void relight();
    RoomChange& changeAt(const Pose& pose);
    [[nodiscard]] std::string sentence(const Units& units) const;

    Workplace& place_;
    Volumes& volumes_;
    State state_ = State::Idle;
    std::string object_;
    std::optional<VolumeRequest> request_;
    std::uint64_t preparing_ = 0, asking_ = 0;  // jobs
    std::shared_ptr<const LitProject> of_;      // that is prepared, or being so
    std::shared_ptr<Live> live_;
    Pose pose_;
    WorkingSurfaceLight light_;
    LightRequirement requirement_;
    std::string requiredBy_;
    bool requirementKnown_ = false;
    std::optional<RoomChange> roomChange_;
};

}  // namespace luxdeck::gui
