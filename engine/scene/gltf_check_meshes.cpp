#include "engine/scene/gltf_check.h"

#include <algorithm>
#include <map>
#include <set>

namespace manylight {
namespace {

struct AccessorFacts {
    std::string type;
    int64_t componentType = 0;
    int64_t count = 0;
    int64_t bufferView = -1;
    bool isNormalised = false;
};

AccessorFacts factsOf(const JsonView& root, const JsonView& owner, std::string_view key) {
    checkGltfIndex(root, owner, key, "accessors");
    const JsonView accessor = root.at("accessors").at(static_cast<size_t>(owner.at(key).integer(0, INT32_MAX)));
    return {.type = accessor.at("type").text(),
            .componentType = accessor.at("componentType").integer(0, INT32_MAX),
            .count = accessor.at("count").integer(1, INT32_MAX),
            .bufferView = accessor.has("bufferView") ? accessor.at("bufferView").integer(0, INT32_MAX) : -1,
            .isNormalised = accessor.has("normalized") && accessor.at("normalized").boolean()};
}

/// Name and set of an attribute: "TEXCOORD_1" is {"TEXCOORD", 1}; the set is -1 if there is none.
std::pair<std::string, int> splitSemantic(const std::string& name) {
    const size_t bar = name.rfind('_');
    const bool hasSet = bar != std::string::npos && bar + 1 < name.size() && name.size() - bar < 4 &&
                        std::all_of(name.begin() + static_cast<std::ptrdiff_t>(bar) + 1, name.end(),
                                    [](char c) { return c >= '0' && c <= '9'; });
    if (!hasSet) return {name, -1};
    return {name.substr(0, bar), std::stoi(name.substr(bar + 1))};
}

void checkSkinFormat(const JsonView& attribute, const std::string& semantic, const AccessorFacts& facts,
                     Warnings& warnings) {
    const bool isUnsigned = facts.componentType == 5121 || facts.componentType == 5123;
    if (semantic == "JOINTS" && (facts.type != "VEC4" || !isUnsigned || facts.isNormalised))
        attribute.failExpected("an accessor of VEC4, unsigned bytes or shorts, not normalised");
    if (semantic == "WEIGHTS" && (facts.type != "VEC4" || (!isUnsigned && facts.componentType != 5126)))
        attribute.failExpected("an accessor of VEC4, float or unsigned bytes or shorts");
    if (semantic == "WEIGHTS" && facts.componentType != 5126 && !facts.isNormalised)
        warnings.add("glTF joint weights of integers that are not normalised", attribute.path());
}

/// The attributes that the importer reads must have a layout it can read; all others only have to be plausible.
void checkAttributeFormat(const JsonView& attributes, const std::string& name, const AccessorFacts& facts,
                          Warnings& warnings) {
    const auto [semantic, set] = splitSemantic(name);
    const JsonView attribute = attributes.at(name);
    const bool isReadable = facts.componentType != 5125;
    if ((name == "POSITION" || name == "NORMAL") && (facts.type != "VEC3" || !isReadable))
        attribute.failExpected("an accessor of VEC3, float or small integers");
    if (semantic == "TEXCOORD" && (facts.type != "VEC2" || !isReadable))
        attribute.failExpected("an accessor of VEC2, float or small integers");
    const bool isColour = semantic == "COLOR" && set == 0;
    if (isColour && ((facts.type != "VEC3" && facts.type != "VEC4") || !isReadable))
        attribute.failExpected("an accessor of VEC3 or VEC4, float or small integers");
    if (isColour && facts.componentType != 5126 && !facts.isNormalised)
        warnings.add("glTF colours of integers that are not normalised", attribute.path());
    if (semantic == "JOINTS" || semantic == "WEIGHTS") checkSkinFormat(attribute, semantic, facts, warnings);
    if (facts.componentType == 5125) warnings.add("glTF attributes of 32-bit integers", attribute.path());
    static const std::set<std::string> kPlain = {"POSITION", "NORMAL", "TANGENT"};
    static const std::set<std::string> kIndexed = {"TEXCOORD", "COLOR", "JOINTS", "WEIGHTS"};
    const bool isKnown = name.starts_with('_') || kPlain.contains(name) || (set >= 0 && kIndexed.contains(semantic));
    if (!isKnown) warnings.add("glTF attributes of unknown meaning ignored", attribute.path());
}

/// Numbered attributes must be numbered from zero without a gap; joints and weights come in pairs.
void checkSets(const JsonView& attributes, const std::map<std::string, int>& setCounts, Warnings& warnings) {
    for (const auto& [semantic, count] : setCounts)
        for (int set = 0; set < count; ++set)
            if (!attributes.has(fmt::format("{}_{}", semantic, set)))
                warnings.add("glTF attributes not numbered from zero", attributes.path());
    const auto countOf = [&](const char* semantic) {
        const auto found = setCounts.find(semantic);
        return found == setCounts.end() ? 0 : found->second;
    };
    if (countOf("JOINTS") != countOf("WEIGHTS")) warnings.add("glTF joints without weights", attributes.path());
}

class MeshChecker {
  public:
    MeshChecker(const JsonView& root, Warnings& warnings) : root_(root), warnings_(warnings) {}

    void checkMesh(const JsonView& mesh) {
        const JsonView primitives = mesh.at("primitives").expectArray();
        if (primitives.size() == 0) primitives.failExpected("at least one primitive");
        std::set<size_t> targetCounts;
        for (size_t i = 0; i < primitives.size(); ++i) {
            checkPrimitive(primitives.at(i).expectObject());
            targetCounts.insert(primitives.at(i).has("targets") ? primitives.at(i).at("targets").size() : 0);
        }
        if (targetCounts.size() > 1) warnings_.add("glTF meshes with unequal morph targets", mesh.path());
        if (!mesh.has("weights")) return;
        const JsonView weights = mesh.at("weights").expectArray();
        for (size_t i = 0; i < weights.size(); ++i) weights.at(i).number();
        if (weights.size() != *targetCounts.begin()) warnings_.add("glTF morph weights of wrong number", mesh.path());
    }

    /// Interleaved data needs a stride; one view must not serve both as vertices and as indices.
    void checkViews() {
        for (const auto& [view, accessors] : vertexViews_) {
            const JsonView bufferView = root_.at("bufferViews").at(static_cast<size_t>(view));
            if (accessors.size() > 1 && !bufferView.has("byteStride"))
                warnings_.add("glTF vertex data shared without byteStride", bufferView.path());
            if (indexViews_.contains(view)) warnings_.add("glTF buffer views of mixed use", bufferView.path());
            checkTarget(bufferView, 34962);
        }
        for (const int64_t view : indexViews_) {
            const JsonView bufferView = root_.at("bufferViews").at(static_cast<size_t>(view));
            if (bufferView.has("byteStride")) warnings_.add("glTF indices with byteStride", bufferView.path());
            checkTarget(bufferView, 34963);
        }
    }

  private:
    void checkTarget(const JsonView& bufferView, int64_t expected) {
        if (bufferView.has("target") && bufferView.at("target").integer(0, INT32_MAX) != expected)
            warnings_.add("glTF buffer views of mixed use", bufferView.path());
    }

    void checkPrimitive(const JsonView& primitive) {
        checkGltfIndex(root_, primitive, "material", "materials");
        if (primitive.has("mode")) primitive.at("mode").integer(0, 6);
        const int64_t vertexCount = checkAttributes(primitive.at("attributes").expectObject());
        if (primitive.has("indices")) checkIndices(primitive);
        if (primitive.has("targets")) checkTargets(primitive, vertexCount);
        if (primitive.has("material")) checkTexcoords(primitive);
    }

    int64_t checkAttributes(const JsonView& attributes) {
        int64_t count = -1;
        std::map<std::string, int> setCounts;
        if (attributes.size() == 0) warnings_.add("glTF primitives without attributes", attributes.path());
        for (const auto& [name, value] : attributes.json().items()) {
            const AccessorFacts facts = factsOf(root_, attributes, name);
            if (count >= 0 && facts.count != count)
                attributes.at(name).failExpected(fmt::format("an accessor with {} elements", count));
            count = facts.count;
            checkAttributeFormat(attributes, name, facts, warnings_);
            if (const auto [semantic, set] = splitSemantic(name); set >= 0 && !name.starts_with('_'))
                ++setCounts[semantic];
            if (name == "POSITION") checkPositionBounds(attributes);
            if (facts.bufferView >= 0) vertexViews_[facts.bufferView].insert(attributes.json().at(name).get<int64_t>());
            checkAlignment(attributes.at(name));
        }
        checkSets(attributes, setCounts, warnings_);
        return count;
    }

    void checkAlignment(const JsonView& attribute) {
        const JsonView accessor = root_.at("accessors").at(static_cast<size_t>(attribute.integer(0, INT32_MAX)));
        if (accessor.has("byteOffset") && accessor.at("byteOffset").integer(0, INT64_MAX) % 4 != 0)
            warnings_.add("glTF vertex data not aligned to four bytes", accessor.path());
    }

    void checkPositionBounds(const JsonView& attributes) {
        const auto index = static_cast<size_t>(attributes.at("POSITION").integer(0, INT32_MAX));
        const JsonView accessor = root_.at("accessors").at(index);
        if (!accessor.has("min") || !accessor.has("max"))
            warnings_.add("glTF positions without min and max", accessor.path());
    }

    void checkIndices(const JsonView& primitive) {
        const AccessorFacts facts = factsOf(root_, primitive, "indices");
        const bool isUnsigned =
            facts.componentType == 5121 || facts.componentType == 5123 || facts.componentType == 5125;
        if (facts.type != "SCALAR" || !isUnsigned || facts.isNormalised)
            primitive.at("indices").failExpected("an accessor of unsigned SCALAR, not normalised");
        if (facts.bufferView >= 0) indexViews_.insert(facts.bufferView);
    }

    void checkTargets(const JsonView& primitive, int64_t vertexCount) {
        const JsonView targets = primitive.at("targets").expectArray();
        for (size_t i = 0; i < targets.size(); ++i) {
            const JsonView target = targets.at(i).expectObject();
            for (const auto& [name, value] : target.json().items()) {
                const AccessorFacts facts = factsOf(root_, target, name);
                if (facts.count != vertexCount) target.at(name).failExpected(fmt::format("{} elements", vertexCount));
                if (!primitive.at("attributes").has(name))
                    warnings_.add("glTF morph targets without a base attribute", target.path());
                else
                    checkTargetFormat(target, primitive.at("attributes"), name, facts);
                if (name == "POSITION") checkPositionBounds(target);
                if (indexViews_.contains(facts.bufferView))
                    warnings_.add("glTF buffer views of mixed use", target.path());
            }
        }
    }

    void checkTargetFormat(const JsonView& target, const JsonView& attributes, const std::string& name,
                           const AccessorFacts& facts) {
        checkAttributeFormat(target, name, facts, warnings_);
        const bool mayDiffer = splitSemantic(name).first == "TANGENT";  // without its fourth component, and not read
        if (!mayDiffer && facts.type != factsOf(root_, attributes, name).type)
            warnings_.add("glTF morph targets of another type than their base", target.path());
    }

    /// Counts textures of the material, of whatever kind, whose coordinates the primitive lacks.
    void checkTexcoords(const JsonView& primitive) {
        const auto material = static_cast<size_t>(primitive.at("material").integer(0, INT32_MAX));
        checkTexcoordsIn(root_.at("materials").at(material).json(), primitive);
    }

    void checkTexcoordsIn(const Json& json, const JsonView& primitive) {
        if (!json.is_object()) return;
        for (const auto& [key, value] : json.items()) {
            if (key.ends_with("Texture") && value.is_object() && value.contains("index")) {
                const int set = value.contains("texCoord") && value["texCoord"].is_number_integer()
                                    ? value["texCoord"].get<int>()
                                    : 0;
                if (!primitive.at("attributes").has(fmt::format("TEXCOORD_{}", set)))
                    warnings_.add("glTF primitives without the texture coordinates of their material",
                                  primitive.path());
            }
            checkTexcoordsIn(value, primitive);
        }
    }

    const JsonView& root_;
    Warnings& warnings_;
    std::map<int64_t, std::set<int64_t>> vertexViews_;  // accessors by the buffer view they read
    std::set<int64_t> indexViews_;
};

}  // namespace

void checkGltfMeshes(const JsonView& root, Warnings& warnings) {
    MeshChecker checker(root, warnings);
    forEachGltf(root, "meshes", [&](const JsonView& mesh) { checker.checkMesh(mesh); });
    checker.checkViews();
}

}  // namespace manylight
