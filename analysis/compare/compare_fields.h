#pragma once

#include "analysis/compare/comparison.h"

/// The fields of a comparison, listed once: an archive calls visit() and sees each by name, to write it or to read it,
/// so that the two cannot differ.
namespace luxdeck::compare_fields {

template <class A> void visit(A& a, ComparedReference& x) {
    a("subject", x.subject), a("picture", x.picture), a("width", x.width), a("height", x.height), a("values", x.values), a("algorithm", x.algorithm);
    a("relativeError", x.relativeError), a("asked", x.asked), a("samples", x.samples), a("seconds", x.seconds), a("reused", x.reused);
}
template <class A> void visit(A& a, ComparedAlgorithm& x) {
    a("name", x.name), a("claimedBias", x.claimedBias), a("interreflection", x.interreflection), a("refused", x.refused);
}
template <class A> void visit(A& a, ComparedRun& x) {
    a("subject", x.subject), a("algorithm", x.algorithm), a("rung", x.rung), a("budgetSeconds", x.budgetSeconds), a("seconds", x.seconds);
    a("setupSeconds", x.setupSeconds), a("samples", x.samples), a("effort", x.effort), a("preparedBytes", x.preparedBytes), a("peakBytes", x.peakBytes);
    a("rejectedSamples", x.rejected), a("rms", x.rms), a("rmsCi95", x.rmsCi95), a("rmsAtMost", x.rmsAtMost), a("max", x.max), a("p99", x.p99);
    a("bias", x.bias), a("biasCi95", x.biasCi95), a("meanError", x.meanError), a("meanErrorCi95", x.meanErrorCi95);
}
template <class A> void visit(A& a, ComparedSlope& x) {
    a("subject", x.subject), a("algorithm", x.algorithm), a("slope", x.slope), a("ci95", x.ci95), a("runs", x.runs);
}
template <class A> void visit(A& a, ComparedTime& x) {
    a("subject", x.subject), a("algorithm", x.algorithm), a("error", x.error), a("reached", x.time.how), a("seconds", x.time.seconds);
}
template <class A> void visit(A& a, ComparedPlace& x) {
    a("subject", x.subject), a("algorithm", x.algorithm), a("place", x.place), a("seconds", x.seconds), a("rms", x.rms);
}
template <class A> void visit(A& a, WorstValue& x) {
    a("subject", x.subject), a("algorithm", x.algorithm), a("grid", x.grid), a("x", x.position.x), a("y", x.position.y), a("z", x.position.z);
    a("column", x.column), a("row", x.row), a("reference", x.reference), a("referenceCi95", x.referenceCi95), a("value", x.value), a("error", x.error);
}
template <class A> void visit(A& a, ComparedGrid& x) {
    a("name", x.name), a("columns", x.columns), a("rows", x.rows), a("x", x.x), a("y", x.y), a("z", x.z);
}
template <class A> void visit(A& a, ErrorMap& x) {
    a("subject", x.subject), a("algorithm", x.algorithm), a("grid", x.grid), a("columns", x.columns), a("rows", x.rows), a("errors", x.errors);
}
template <class A> void visit(A& a, ComparedVolume& x) {
    a("algorithm", x.algorithm), a("part", x.part), a("seconds", x.seconds), a("rms", x.rms), a("p99", x.p99), a("max", x.max), a("noise", x.noise);
    a("meanLux", x.meanLux), a("referenceMeanLux", x.referenceMeanLux);
}
template <class A> void visit(A& a, Comparison& x) {
    a("project", x.project), a("complete", x.complete), a("seed", x.seed), a("threads", x.threads), a("repetitions", x.repetitions), a("seconds", x.seconds), a("coreTime", x.coreTime);
    a("algorithms", x.algorithms), a("reference", x.reference), a("grids", x.grids), a("runs", x.runs), a("slopes", x.slopes), a("timeTo", x.timeTo), a("order", x.order);
    a("worst", x.worst), a("maps", x.maps), a("volumes", x.volumes), a("warnings", x.warnings), a("sceneHash", x.sceneHash), a("projectHash", x.projectHash), a("version", x.version);
}

}  // namespace luxdeck::compare_fields
