#pragma once

#include "analysis/report/report_contents.h"

#include <array>
#include <string>
#include <utility>

/// The fields of everything a report holds, listed once: an archive calls visit() and sees each by name, to
/// write it or to read it, so that the two cannot differ.
namespace luxdeck::fields {

template <class E>
struct EnumNames;
template <>
struct EnumNames<Verdict> {
    static constexpr std::array<std::pair<Verdict, const char*>, 4> kNames{
        {{Verdict::None, "none"}, {Verdict::Met, "met"}, {Verdict::NotMet, "not met"}, {Verdict::Undecided, "undecided"}}};
    static constexpr const char* kAll = "none, met, not met or undecided";
};
template <>
struct EnumNames<GridKind> {
    static constexpr std::array<std::pair<GridKind, const char*>, 2> kNames{
        {{GridKind::Planar, "planar"}, {GridKind::Cylindrical, "cylindrical"}}};
    static constexpr const char* kAll = "planar or cylindrical";
};
template <>
struct EnumNames<ReportSection> {
    static constexpr std::array<std::pair<ReportSection, const char*>, 4> kNames{
        {{ReportSection::Grids, "grids"}, {ReportSection::Schedule, "schedule"}, {ReportSection::Accuracy, "accuracy"}, {ReportSection::Method, "method"}}};
    static constexpr const char* kAll = "grids, schedule, accuracy or method";
};
template <>
struct EnumNames<PlanLine> {
    static constexpr std::array<std::pair<PlanLine, const char*>, 3> kNames{
        {{PlanLine::Solid, "solid"}, {PlanLine::Glass, "glass"}, {PlanLine::Furniture, "furniture"}}};
    static constexpr const char* kAll = "solid, glass or furniture";
};

template <class E>
const char* namesOf() { return EnumNames<E>::kAll; }

template <class E>
const char* name(E value) {
    for (const auto& [each, text] : EnumNames<E>::kNames)
        if (each == value) return text;
    return "";
}

template <class E>
bool fromName(const std::string& text, E& value) {
    for (const auto& [each, known] : EnumNames<E>::kNames)
        if (text == known) return value = each, true;
    return false;
}

template <class A> void visit(A& a, NamedText& x) { a("name", x.name), a("text", x.text); }
template <class A> void visit(A& a, LeftOut& x) { a("what", x.what), a("why", x.why); }
template <class A> void visit(A& a, Interval& x) { a("value", x.value), a("ci95", x.ci95); }

template <class A> void visit(A& a, ProjectInfo& x) {
    a("name", x.name), a("client", x.client), a("designer", x.designer), a("location", x.location);
    a("date", x.date), a("description", x.description), a("notes", x.notes);
}
template <class A> void visit(A& a, ScheduleRow& x) {
    a("id", x.id), a("description", x.description), a("manufacturer", x.manufacturer), a("count", x.count);
    a("lumensEach", x.lumensEach), a("wattsEach", x.wattsEach), a("maintenanceFactor", x.maintenanceFactor);
    a("dimming", x.dimming), a("cctK", x.cctK), a("file", x.file), a("fileHash", x.fileHash);
}
template <class A> void visit(A& a, MaterialRow& x) {
    a("name", x.name), a("kind", x.kind), a("reflectance", x.reflectance), a("source", x.source);
}
template <class A> void visit(A& a, PlanSegment& x) {
    a("line", x.line), a("x0", x.x0), a("y0", x.y0), a("x1", x.x1), a("y1", x.y1);
}
template <class A> void visit(A& a, PlanLuminaire& x) {
    a("id", x.id), a("position", x.position), a("lengthM", x.lengthM), a("widthM", x.widthM), a("angle", x.angle), a("round", x.round);
}
template <class A> void visit(A& a, RoomPlan& x) {
    a("cutHeightM", x.cutHeightM), a("segments", x.segments), a("luminaires", x.luminaires);
}
template <class A> void visit(A& a, ColourScale& x) {
    a("unit", x.unit), a("minimum", x.minimum), a("maximum", x.maximum), a("logarithmic", x.logarithmic), a("map", x.map);
}
template <class A> void visit(A& a, ReportView& x) {
    a("name", x.name), a("operator", x.operatorName), a("operatorText", x.operatorText), a("exposure", x.exposure);
    a("seconds", x.seconds), a("relativeError", x.relativeError), a("scale", x.scale);
    a.bytes("png", x.png);
}
template <class A> void visit(A& a, Requirement& x) {
    a("name", x.name), a("source", x.source), a("meanLux", x.meanLux), a("minimumLux", x.minimumLux);
    a("uniformity", x.uniformity), a("where", x.where);
}
/// The keys of `solve --json`, and the intervals of the parts.
template <class A> void visit(A& a, PointResult& p) {
    a("x", p.position.x), a("y", p.position.y), a("z", p.position.z);
    a("nx", p.normal.x), a("ny", p.normal.y), a("nz", p.normal.z);
    a("lx", p.total.value), a("ci95", p.total.ci95), a("direct", p.direct.value), a("directCi95", p.direct.ci95);
    a("indirect", p.indirect.value), a("indirectCi95", p.indirect.ci95), a("samples", p.samples), a("insideSolid", p.insideSolid);
}
template <class A> void visit(A& a, JudgedInterval& x) {
    a("value", x.interval.value), a("ci95", x.interval.ci95), a("required", x.required), a("verdict", x.verdict);
}
template <class A> void visit(A& a, GridResult& x) {
    a("name", x.name), a("kind", x.kind), a("columns", x.columns), a("rows", x.rows), a("spacingU", x.spacingU);
    a("spacingV", x.spacingV), a("borderM", x.borderM), a("origin", x.origin), a("u", x.u), a("v", x.v);
    a("mean", x.mean), a("min", x.minimum), a("uniformity", x.uniformity), a("maximumLux", x.maximumLux);
    a("requirements", x.requirements), a("points", x.points);
}
template <class A> void visit(A& a, ErrorAtTime& x) {
    a("seconds", x.seconds), a("relativeError", x.relativeError), a("rmsPointError", x.rmsPointError), a("samples", x.samples);
}
template <class A> void visit(A& a, Condition& x) {
    a("meanReflectance", x.meanReflectance), a("amplification", x.amplification), a("effectiveReplicates", x.effectiveReplicates);
}
template <class A> void visit(A& a, SolveResult& x) {
    a("project", x.project), a("complete", x.complete), a("targetReached", x.targetReached), a("targetError", x.targetError);
    a("seconds", x.seconds), a("setupSeconds", x.setupSeconds), a("predictedSeconds", x.predictedSeconds);
    a("samples", x.samples), a("rays", x.rays), a("algorithm", x.algorithm), a("ambientLux", x.ambientLux);
    a("seed", x.seed), a("threads", x.threads), a("grids", x.grids), a("trace", x.trace), a("leftOut", x.leftOut);
    a("warnings", x.warnings), a("truncatedFraction", x.truncatedFraction), a("condition", x.condition), a("rejectedSamples", x.rejectedSamples);
    a("sceneHash", x.sceneHash), a("projectHash", x.projectHash), a("version", x.version), a("kernel", x.kernel);
}
template <class A> void visit(A& a, ReportContents& x) {
    a("info", x.info), a("created", x.created), a("schedule", x.schedule), a("floorAreaM2", x.floorAreaM2);
    a("floorAreaSource", x.floorAreaSource), a("materials", x.materials), a("plan", x.plan), a("solve", x.solve);
    a("views", x.views), a("comparison", x.comparison), a("methodText", x.methodText), a("leftOut", x.leftOut), a("facts", x.facts);
}

}  // namespace luxdeck::fields
