// A compiled graph as text (for reviewed snapshots), as DOT (for a picture) and as JSON (for tools).
#pragma once

#include "engine/core/report.h"
#include "engine/graph/compile.h"

namespace manylight {

/// One line per pass, access, barrier, resource and slot. The same graph always gives the same bytes.
std::string toText(const FrameGraph& graph, const CompiledGraph& compiled);
/// For Graphviz: passes are boxes, versions of resources ellipses; what was culled is dashed.
std::string toDot(const FrameGraph& graph, const CompiledGraph& compiled);
/// {"passes": [...], "resources": [...], "slots": [...]}; passes in declared order, culled ones marked.
Json toJson(const FrameGraph& graph, const CompiledGraph& compiled);

}  // namespace manylight
