#include "analysis/compare/compare.h"

#include "analysis/compare/effort.h"
#include "analysis/compare/keep_reference.h"
#include "analysis/compare/run_errors.h"
#include "analysis/compare/subject.h"
#include "analysis/grids/sampling_run.h"
#include "engine/core/parallel.h"
#include "engine/core/rng.h"
#include "engine/core/version.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

namespace luxdeck {

namespace {

constexpr double kSetupShare = 0.5;          // of the budget, where something is prepared
constexpr std::uint32_t kMostSamples = 1U << 24;
constexpr std::uint64_t kPilotPurpose = 0x914, kRunPurpose = 0x5c4, kPreparePurpose = 0x9e4;

/// An algorithm's random numbers do not depend on which others it is compared with.
std::uint64_t streamOf(const std::string& algorithm) {
    std::uint64_t hash = 0;
    for (const char c : algorithm) hash = mix64(hash ^ static_cast<unsigned char>(c));
    return hash;
}

std::uint32_t wholeSamples(double wanted, std::uint32_t least) {
    const double count = std::clamp(std::round(wanted / least), 1.0, static_cast<double>(kMostSamples));
    return static_cast<std::uint32_t>(count) * least;
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    const std::size_t n = values.size();
    return n % 2 != 0 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

struct Plan {
    double budgetSeconds = 0, effort = 1;
    std::uint32_t samples = 0;
};

/// An algorithm on a subject: what it costs, as far as it has been seen.
struct Contender {
    std::size_t algorithm = 0, subject = 0;
    double secondsPerSample = 0;
    Plan last;                               // of its largest run so far
    std::vector<Field> values;               // its repetitions
};

class Ladder {
public:
    Ladder(const Project& project, const LitScene& lit, const CompareSettings& settings, std::vector<std::unique_ptr<Subject>> subjects,
           const Progress& progress, const AfterRun& afterRun)
        : lit_(lit), settings_(settings), subjects_(std::move(subjects)), progress_(progress), afterRun_(afterRun), clock_(settings.coreTime ? coreSeconds : wallSeconds) {
        c_.project = project.info.name, c_.seed = settings.seed, c_.threads = threadCount(), c_.repetitions = settings.repetitions;
        c_.coreTime = settings.coreTime;
        c_.sceneHash = project.scene.hash, c_.projectHash = project.fileHash, c_.version = kVersion;
        for (const auto& name : settings.algorithms) {
            const auto* known = algorithmNamed(name);
            c_.algorithms.push_back({name, known->bias, known->interreflection, ""});
        }
    }

    Result<Comparison> run(const Project& project) {
        if (auto ok = findReferences(project); !ok) return ok.error();
        if (auto ok = measureSetups(); !ok) return ok.error();
        if (auto ok = measureRates(); !ok) return ok.error();
        for (int rung = 0; rung < settings_.rungs; ++rung)
            for (auto& contender : contenders_)
                if (!progress_.cancelled()) runRung(contender, rung);
        finish();
        return std::move(c_);
    }

private:
    Result<void> findReferences(const Project& project) {
        ReferenceKeeper keeper(project, settings_);
        if (auto ok = keeper.open(c_.warnings); !ok) return ok;
        for (const auto& subject : subjects_) {
            if (progress_.cancelled() && !references_.empty()) break;
            auto reference = keeper.get(*subject, lit_, progress_);
            // Stopped before this one: what the others have is kept, in the file too.
            if (!reference && reference.error().code == ErrorCode::Cancelled && !references_.empty()) break;
            if (!reference) return reference.error();
            references_.push_back(reference->fields(*subject));
            addGrids(*subject, c_);
            c_.reference.push_back(keeper.describe(*subject, *reference, relativeError95(references_.back())));
            tellValues(references_.size() - 1, "", 0, references_.back().mean());
        }
        return keeper.close();
    }

    [[nodiscard]] AlgorithmSettings settingsOf(const std::string& algorithm, double effort, std::uint64_t item) const {
        auto out = settings_.algorithmSettings;
        out.effort = effort;
        out.seed = streamSeed(streamSeed(settings_.seed, streamOf(algorithm)), item, kPreparePurpose);
        out.progress = &progress_;
        return out;
    }

    /// What preparing costs; algorithms that refuse the scene take no part.
    Result<void> measureSetups() {
        std::string refusals;
        for (std::size_t a = 0; a < c_.algorithms.size() && !progress_.cancelled(); ++a) {
            auto& algorithm = c_.algorithms[a];
            tell(fmt::format("preparing {}", algorithm.name));
            const auto cost = settings_.samples ? plainSetup(algorithm.name) : measureSetup(algorithm.name, lit_, settingsOf(algorithm.name, 1, 0), clock_);
            if (!cost && cost.error().code == ErrorCode::Cancelled) return {};
            if (!cost) {
                algorithm.refused = cost.error().text();
                refusals += fmt::format("{}{}: {}", refusals.empty() ? "" : "; ", algorithm.name, algorithm.refused);
                c_.warnings.push_back(fmt::format("{} takes no part: {}", algorithm.name, algorithm.refused));
                continue;
            }
            costs_[a] = *cost;
            for (std::size_t s = 0; s < references_.size(); ++s) contenders_.push_back({a, s, 0, {}, {}});
        }
        if (contenders_.empty() && !progress_.cancelled()) return Error{ErrorCode::InvalidArgument, "no algorithm can light this scene: " + refusals};
        return {};
    }

    /// With given numbers of samples the clock has no say, so only whether the algorithm can be made is asked.
    [[nodiscard]] Result<SetupCost> plainSetup(const std::string& algorithm) const {
        const auto made = prepare(algorithm, lit_, settingsOf(algorithm, effortOfRung(0), 0), clock_);
        if (!made) return made.error();
        return SetupCost{};
    }

    /// The time of one sample for every point or pixel, from a first measurement of a small part of the smallest budget.
    Result<void> measureRates() {
        if (settings_.samples) return {};
        for (auto& contender : contenders_) {
            if (progress_.cancelled()) return {};
            const auto& algorithm = c_.algorithms[contender.algorithm].name;
            const auto& subject = *subjects_[contender.subject];
            const double least = settings_.budgetSeconds * std::ldexp(1.0, 1 - settings_.rungs);
            const auto made = prepare(algorithm, lit_, settingsOf(algorithm, costs_[contender.algorithm].effortFor(kSetupShare * least), 0), clock_);
            if (!made) return made.error().code == ErrorCode::Cancelled ? Result<void>{} : made.error();
            std::uint32_t samples = subject.leastSamples();
            while (true) {
                const double begun = clock_();
                const auto measured = subject.measure(*made->estimator, samples, streamSeed(settings_.seed, samples, kPilotPurpose),
                                                      fmt::format("rate of {}", algorithm), progress_);
                const double seconds = clock_() - begun;
                contender.secondsPerSample = seconds / samples;
                if (!measured.whole || seconds > 0.2 * least || samples >= kMostSamples / 4) break;
                samples *= 4;
            }
        }
        return {};
    }

    [[nodiscard]] double effortOfRung(int rung) const { return std::ldexp(1.0, rung + 1 - settings_.rungs); }

    [[nodiscard]] Plan planOf(const Contender& contender, int rung) const {
        const double part = std::ldexp(1.0, rung + 1 - settings_.rungs);
        const auto least = subjects_[contender.subject]->leastSamples();
        if (settings_.samples) return {0, effortOfRung(rung), wholeSamples(*settings_.samples * part, least)};
        const auto& cost = costs_.at(contender.algorithm);
        Plan plan;
        plan.budgetSeconds = settings_.budgetSeconds * part;
        plan.effort = cost.effortFor(kSetupShare * plan.budgetSeconds);
        const double left = std::max(plan.budgetSeconds - cost.secondsOf(plan.effort), 0.1 * plan.budgetSeconds);
        plan.samples = wholeSamples(left / contender.secondsPerSample, least);
        return plan;
    }

    /// All repetitions of one run; nothing is kept of one that was interrupted. A budget in which no less can be done than
    /// in the one below is passed over.
    void runRung(Contender& contender, int rung) {
        const auto& algorithm = c_.algorithms[contender.algorithm].name;
        const auto& subject = *subjects_[contender.subject];
        const auto plan = planOf(contender, rung);
        ++runsBegun_;
        if (plan.samples == contender.last.samples && plan.effort <= contender.last.effort) return;
        ComparedRun out;
        out.subject = subject.name(), out.algorithm = algorithm, out.rung = rung;
        out.budgetSeconds = plan.budgetSeconds, out.samples = plan.samples, out.effort = plan.effort;
        std::vector<double> setups, totals, rates;
        std::vector<Field> values;
        resetPeak();
        for (int r = 0; r < settings_.repetitions; ++r) {
            const auto stage = tell(stageOf(contender, rung, r));
            const auto item = static_cast<std::uint64_t>(rung) * 4096 + static_cast<std::uint64_t>(r);
            const auto made = prepare(algorithm, lit_, settingsOf(algorithm, plan.effort, item + 1), clock_);
            if (!made) {
                if (made.error().code != ErrorCode::Cancelled) c_.warnings.push_back(fmt::format("{} with effort {:.3g}: {}", algorithm, plan.effort, made.error().text()));
                return;
            }
            const auto seed = streamSeed(streamSeed(settings_.seed, streamOf(algorithm)), item, kRunPurpose + contender.subject);
            const double begun = clock_();
            auto measured = subject.measure(*made->estimator, plan.samples, seed, stage, progress_);
            if (!measured.whole) return;
            const double seconds = clock_() - begun;
            setups.push_back(made->seconds), totals.push_back(made->seconds + seconds), rates.push_back(seconds / plan.samples);
            values.push_back(std::move(measured.values));
            out.preparedBytes = std::max<std::uint64_t>(out.preparedBytes, made->estimator->bytes());
            out.rejected += measured.rejected;
        }
        out.peakBytes = peakBytes();
        out.setupSeconds = median(setups), out.seconds = median(totals);
        contender.secondsPerSample = median(rates);
        enterErrors(runErrors(references_[contender.subject], values), out);
        c_.runs.push_back(out);
        contender.last = plan;
        contender.values = std::move(values);
        tellValues(contender.subject, algorithm, rung, meanOf(contender.values));
    }

    /// algorithm  empty: of the reference
    void tellValues(std::size_t subject, const std::string& algorithm, int rung, Field values) {
        if (!afterRun_) return;
        const auto& described = c_.reference[subject];
        ComparedValues last{described.subject, algorithm, rung, described.width, described.height, std::move(values), {}};
        if (!algorithm.empty()) last.maps = mapsOf(*subjects_[subject], algorithm, relativeErrors(references_[subject], last.values));
        c_.complete = false;
        c_.seconds = watch_.seconds();
        summarize(c_);
        afterRun_(c_, last);
    }

    [[nodiscard]] std::string stageOf(const Contender& contender, int rung, int repetition) const {
        return fmt::format("run {} of {}: {} on {}, repetition {} of {}", runsBegun_, contenders_.size() * static_cast<std::size_t>(settings_.rungs),
                           c_.algorithms[contender.algorithm].name, subjects_[contender.subject]->name(), repetition + 1, settings_.repetitions) +
               (settings_.samples ? "" : fmt::format(", {:.3g} s", settings_.budgetSeconds * std::ldexp(1.0, rung + 1 - settings_.rungs)));
    }

    std::string tell(std::string stage) const {
        ProgressState state;
        state.stage = stage;
        progress_.report(state);
        return stage;
    }

    void finish() {
        c_.complete = !progress_.cancelled();
        for (const auto& contender : contenders_)
            if (!contender.values.empty())
                addPlaces(*subjects_[contender.subject], references_[contender.subject], c_.algorithms[contender.algorithm].name, contender.values, c_);
        summarize(c_);
        addWarnings(c_);
        c_.seconds = watch_.seconds();
    }

    const LitScene& lit_;
    const CompareSettings& settings_;
    std::vector<std::unique_ptr<Subject>> subjects_;
    const Progress& progress_;
    const AfterRun& afterRun_;
    RunClock clock_;
    std::vector<ReferenceFields> references_;        // of the subjects, in order; fewer when interrupted
    std::map<std::size_t, SetupCost> costs_;         // by algorithm
    std::vector<Contender> contenders_;
    std::size_t runsBegun_ = 0;
    Comparison c_;
    Stopwatch watch_;
};

Result<void> checkSettings(const CompareSettings& s) {
    const auto refuse = [](const std::string& message) { return Error{ErrorCode::InvalidArgument, message}; };
    if (s.rungs < 2 || s.rungs > 12) return refuse(fmt::format("{} rungs, expected 2 .. 12", s.rungs));
    if (s.repetitions < 3 || s.repetitions > 64) return refuse(fmt::format("{} repetitions, expected 3 .. 64", s.repetitions));
    if (s.pictureHeight < 8 || s.pictureHeight > 4096) return refuse(fmt::format("pictures of {} pixels' height, expected 8 .. 4096", s.pictureHeight));
    if (!s.samples && !(s.budgetSeconds > 0 && s.budgetSeconds <= 1e6)) return refuse(fmt::format("a budget of {} s, expected more than 0", s.budgetSeconds));
    const std::uint32_t least = (s.grids ? static_cast<std::uint32_t>(kReplicates) : 1U) << (s.rungs - 1);
    if (s.samples && *s.samples < least)
        return refuse(fmt::format("{} samples at the largest of {} rungs, expected at least {}: the smallest takes {}", *s.samples, s.rungs, least, least >> (s.rungs - 1)));
    for (const auto& name : s.algorithms)
        if (algorithmNamed(name) == nullptr) {
            std::string known;
            for (const auto& a : algorithms()) known += (known.empty() ? "" : ", ") + a.name;
            return refuse(fmt::format("no algorithm \"{}\", expected some of: {}", name, known));
        }
    return {};
}

/// In the order of the registry, each once: the answer does not depend on how the question was put.
std::vector<std::string> inOrder(const std::vector<std::string>& asked) {
    std::vector<std::string> out;
    for (const auto& a : algorithms())
        if (asked.empty() || std::ranges::find(asked, a.name) != asked.end()) out.push_back(a.name);
    return out;
}

}  // namespace

Result<std::vector<View>> viewsNamed(const Project& project, const std::vector<std::string>& names) {
    if (names == std::vector<std::string>{"all"}) return project.views;
    std::vector<View> out;
    for (const auto& name : names) {
        const auto found = std::ranges::find(project.views, name, &View::name);
        if (found == project.views.end()) {
            std::string known;
            for (const auto& view : project.views) known += fmt::format("{}\"{}\"", known.empty() ? "" : ", ", view.name);
            return Error{ErrorCode::InvalidArgument, fmt::format("no view \"{}\", expected some of: {}", name, known.empty() ? "none is there" : known), project.file.string()};
        }
        out.push_back(*found);
    }
    return out;
}

Result<Comparison> compare(const Project& project, const LitScene& lit, const CompareSettings& settings, const Progress& progress, const AfterRun& afterRun) {
    if (const auto possible = checkSettings(settings); !possible) return possible.error();
    const auto views = viewsNamed(project, settings.views);
    if (!views) return views.error();
    std::vector<std::unique_ptr<Subject>> subjects;
    if (settings.grids && !project.grids.empty()) {
        auto grids = gridsSubject(project);
        if (!grids) return grids.error();
        subjects.push_back(*std::move(grids));
    }
    for (const auto& view : *views) subjects.push_back(viewSubject(project, lit, view, settings.pictureHeight));
    if (subjects.empty())
        return Error{ErrorCode::InvalidArgument, "has neither a calculation grid nor a view to compare on: add a [[grid]] or a [[view]] (docs/project-format.md)", project.file.string()};
    auto own = settings;
    own.algorithms = inOrder(settings.algorithms);
    return Ladder(project, lit, own, std::move(subjects), progress, afterRun).run(project);
}

}  // namespace luxdeck
