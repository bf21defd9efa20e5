#include "engine/techniques/settings.h"

#include "engine/core/error.h"
#include "shaders/shared/vpl_resample.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <string_view>
#include <utility>

namespace manylight {
namespace {

template <typename Enum>
struct Name {
    Enum value;
    const char* text;
};

constexpr std::array kTechniques = {Name<Technique>{Technique::Deferred, "deferred"},
                                    Name<Technique>{Technique::Forward, "forward"},
                                    Name<Technique>{Technique::ForwardPrepass, "forward-prepass"},
                                    Name<Technique>{Technique::PathTracer, "path-tracer"}};
constexpr std::array kLightings = {Name<Lighting>{Lighting::Local, "local"}, Name<Lighting>{Lighting::Global, "global"},
                                   Name<Lighting>{Lighting::Both, "both"}};
constexpr std::array kClamps = {Name<ClampMode>{ClampMode::Off, "off"}, Name<ClampMode>{ClampMode::Bound, "bound"},
                                Name<ClampMode>{ClampMode::Compensate, "compensate"}};
constexpr std::array kMaterials = {Name<Materials>{Materials::Full, "full"},
                                   Name<Materials>{Materials::Diffuse, "diffuse"}};
constexpr std::array kFilters = {Name<Filter>{Filter::Off, "off"}, Name<Filter>{Filter::Atrous, "atrous"},
                                 Name<Filter>{Filter::Ratio, "ratio"}};
constexpr std::array kQualities = {Name<Quality>{Quality::Draft, "draft"},
                                   Name<Quality>{Quality::Interactive, "interactive"},
                                   Name<Quality>{Quality::Final, "final"}};
constexpr std::array kSequences = {Name<bool>{true, "continued"}, Name<bool>{false, "independent"}};
constexpr std::array kShows = {
    Name<Show>{Show::Picture, "picture"},   Name<Show>{Show::Vpls, "vpls"},      Name<Show>{Show::Normal, "normal"},
    Name<Show>{Show::Albedo, "albedo"},     Name<Show>{Show::Depth, "depth"},    Name<Show>{Show::Position, "position"},
    Name<Show>{Show::Material, "material"}, Name<Show>{Show::CutOff, "cut-off"}, Name<Show>{Show::Rays, "rays"}};
constexpr std::array kCurves = {Name<ToneCurve>{ToneCurve::Linear, "linear"},
                                Name<ToneCurve>{ToneCurve::Reinhard, "reinhard"},
                                Name<ToneCurve>{ToneCurve::Aces, "aces"}};
constexpr std::array kGBuffers = {Name<GBufferBy>{GBufferBy::Auto, "auto"},
                                  Name<GBufferBy>{GBufferBy::Raster, "raster"},
                                  Name<GBufferBy>{GBufferBy::Rays, "rays"}};
constexpr std::array kRays = {Name<RaysBy>{RaysBy::Auto, "auto"}, Name<RaysBy>{RaysBy::Software, "software"},
                              Name<RaysBy>{RaysBy::Hardware, "hardware"}};

template <typename Enum, size_t N>
const char* nameIn(const std::array<Name<Enum>, N>& names, Enum value) {
    for (const auto& entry : names)
        if (entry.value == value) return entry.text;
    return "?";
}

template <typename Enum, size_t N>
Enum parseName(const std::array<Name<Enum>, N>& names, const std::string& option, const std::string& text) {
    std::string dashed = text;
    std::ranges::replace(dashed, '_', '-');
    std::vector<const char*> expected;
    for (const auto& entry : names) {
        if (dashed == entry.text) return entry.value;
        expected.push_back(entry.text);
    }
    failUsage("--{} {}: expected one of {}", option, text, fmt::join(expected, ", "));
}

bool parseSwitch(const std::string& option, const std::string& text) {
    if (text == "on" || text == "true") return true;
    if (text == "off" || text == "false") return false;
    failUsage("--{} {}: expected on or off", option, text);
}

template <typename Integer>
Integer parseInteger(const std::string& option, const std::string& text, int64_t low, int64_t high) {
    int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || value < low || value > high)
        failUsage("--{} {}: expected a whole number from {} to {}", option, text, low, high);
    return static_cast<Integer>(value);
}

float parseNumber(const std::string& option, const std::string& text, float low, float high) {
    float value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !(value >= low && value <= high))
        failUsage("--{} {}: expected a number from {} to {}", option, text, low, high);
    return value;
}

void parseSize(RenderSettings& settings, const std::string& option, const std::string& text) {
    const size_t cross = text.find('x');
    if (cross == std::string::npos) failUsage("--{} {}: expected WIDTHxHEIGHT, like 512x384", option, text);
    settings.width = parseInteger<uint32_t>(option, text.substr(0, cross), 1, 1 << 20);
    settings.height = parseInteger<uint32_t>(option, text.substr(cross + 1), 1, 1 << 20);
}

/// What a preset sets. Its VPLs count only where nobody has asked for another number.
struct Preset {
    uint32_t vplCount;
    uint32_t interleave;
    uint32_t gatherStep;
    uint32_t visibilitySamples;
    uint32_t shadowRays;
    Filter filter;
    ClampMode clamp;
    uint32_t lightSampleCount;
};

Preset presetOf(Quality quality) {
    switch (quality) {
        case Quality::Draft:
            return {12800, 8, 1, 3, 4, Filter::Atrous, ClampMode::Compensate, 9};
        case Quality::Interactive:
            return {12800, 8, 1, 1, 4, Filter::Atrous, ClampMode::Bound, 4};
        case Quality::Final:
            break;
    }
    const RenderSettings standard;
    return {standard.vplCount,   standard.interleave, standard.gatherStep, standard.visibilitySamples,
            standard.shadowRays, standard.filter,     standard.clamp,      standard.lightSampleCount};
}

void applyQuality(RenderSettings& settings, Quality quality) {
    const Preset preset = presetOf(quality);
    if (settings.vplCount == presetOf(settings.quality).vplCount) settings.vplCount = preset.vplCount;
    settings.interleave = preset.interleave;
    settings.gatherStep = preset.gatherStep;
    settings.visibilitySamples = preset.visibilitySamples;
    settings.shadowRays = preset.shadowRays;
    settings.filter = preset.filter;
    settings.clamp = preset.clamp;
    settings.lightSampleCount = preset.lightSampleCount;
    settings.quality = quality;
}

constexpr uint32_t kMostVisibilitySamples = 64;
constexpr uint32_t kMaxVpls = 1u << 21;  // 128 MiB of LightData, a storage buffer's usual limit

struct Setting {
    SettingHelp help;
    std::function<void(RenderSettings&, const std::string& option, const std::string& value)> apply;
    std::function<Json(const RenderSettings&)> read;
};

const std::vector<Setting>& settingTable() {
    using S = RenderSettings;
    using T = const std::string&;
    using C = const RenderSettings&;
    static const std::vector<Setting> table = {
        {{"quality", "draft|interactive|final",
          "presets of --interleave, --shadow-rays, --filter, --visibility-samples, --clamp, --light-samples and, if it "
          "is not given, --vpls; "
          "those given beside it count"},
         [](S& s, T o, T v) { applyQuality(s, parseName(kQualities, o, v)); },
         [](C s) -> Json { return name(s.quality); }},
        {{"technique", "deferred|forward|forward-prepass|path-tracer", "how pixels are shaded"},
         [](S& s, T o, T v) { s.technique = parseName(kTechniques, o, v); },
         [](C s) -> Json { return name(s.technique); }},
        {{"lighting", "local|global|both", "direct light, light from the VPLs, or both"},
         [](S& s, T o, T v) { s.lighting = parseName(kLightings, o, v); },
         [](C s) -> Json { return name(s.lighting); }},
        {{"vpls", "N", "virtual point lights shaded in every frame", 0, 20000},
         [](S& s, T o, T v) { s.vplCount = parseInteger<uint32_t>(o, v, 0, kMaxVpls); },
         [](C s) -> Json { return s.vplCount; }},
        {{"paths", "N", "light paths per frame (0: four for each VPL, but from 256 to 6400 unless there are more VPLs)",
          0, 20000},
         [](S& s, T o, T v) { s.pathCount = parseInteger<uint32_t>(o, v, 0, kMaxVpls); },
         [](C s) -> Json { return s.pathCount; }},
        {{"bounces", "N", "surfaces a light path may meet (-1: unlimited)", -1, 16},
         [](S& s, T o, T v) { s.bounceCount = parseInteger<int>(o, v, -1, kMaxBounces); },
         [](C s) { return s.bounceCount ? Json(*s.bounceCount) : Json(); }},
        {{"russian-roulette", "on|off", "end light paths by the albedo"},
         [](S& s, T o, T v) { s.russianRoulette = parseSwitch(o, v); },
         [](C s) -> Json { return s.russianRoulette; }},
        {{"shadows", "on|off", "shadow rays, also for VPLs"},
         [](S& s, T o, T v) { s.castShadows = parseSwitch(o, v); },
         [](C s) -> Json { return s.castShadows; }},
        {{"shadow-rays", "N",
          "rays of a pixel for VPLs, drawn by what they would give (0: one for every VPL); deferred", 0,
          shared::kMostShadowRays},
         [](S& s, T o, T v) { s.shadowRays = parseInteger<uint32_t>(o, v, 0, shared::kMostShadowRays); },
         [](C s) -> Json { return s.shadowRays; }},
        {{"interleave", "N", "pixels gather from one VPL in N * N, neighbours from others; deferred", 1,
          shared::kMostInterleave},
         [](S& s, T o, T v) { s.interleave = parseInteger<uint32_t>(o, v, 1, shared::kMostInterleave); },
         [](C s) -> Json { return s.interleave; }},
        {{"filter", "off|atrous|ratio",
          "after an interleaved gather or few rays: a filter that stops at edges and fades as frames come in, of the "
          "light of "
          "VPLs, or of the share of it that its few rays say arrives, and of what samples of area lights say; "
          "deferred"},
         [](S& s, T o, T v) { s.filter = parseName(kFilters, o, v); },
         [](C s) -> Json { return name(s.filter); }},
        {{"gather-step", "N",
          "with --filter, in the first frames: every N-th pixel along x and y gathers, and those that see what it does "
          "not; where N does not divide --interleave, the next lower number that does",
          1, 4},
         [](S& s, T o, T v) { s.gatherStep = parseInteger<uint32_t>(o, v, 1, shared::kMostInterleave); },
         [](C s) -> Json { return s.gatherStep; }},
        {{"visibility-samples", "N",
          "with --filter, in the first frames: points of a pixel where a frame asks what is seen; those but the first "
          "borrow light from pixels around that see the same surface",
          1, 16},
         [](S& s, T o, T v) { s.visibilitySamples = parseInteger<uint32_t>(o, v, 1, kMostVisibilitySamples); },
         [](C s) -> Json { return s.visibilitySamples; }},
        {{"temporal", "on|off",
          "when the camera moves, light that was found before is shown on where it can still be seen; deferred"},
         [](S& s, T o, T v) { s.temporal = parseSwitch(o, v); },
         [](C s) -> Json { return s.temporal; }},
        {{"clamp", "off|bound|compensate",
          "leave the geometry term as it is (right on average, but without a variance: errors fall slowly), bound it, "
          "or also "
          "give back what that takes"},
         [](S& s, T o, T v) { s.clamp = parseName(kClamps, o, v); },
         [](C s) -> Json { return name(s.clamp); }},
        {{"clamp-bound", "C",
          "the bound is C * paths^(2/3) / A, or C / A if compensated; A is the area that light reaches", 0.1, 1000},
         [](S& s, T o, T v) { s.clampBound = parseNumber(o, v, 0.0f, 1e30f); },
         [](C s) { return s.clampBound ? Json(*s.clampBound) : Json(); }},
        {{"light-samples", "N", "points on area lights and the environment per pixel and frame", 1, 64},
         [](S& s, T o, T v) { s.lightSampleCount = parseInteger<uint32_t>(o, v, 1, 65536); },
         [](C s) -> Json { return s.lightSampleCount; }},
        {{"sequence", "continued|independent", "frames share low-discrepancy points, or each draws its own"},
         [](S& s, T o, T v) { s.continuesSequences = parseName(kSequences, o, v); },
         [](C s) -> Json { return nameIn(kSequences, s.continuesSequences); }},
        {{"gbuffer", "auto|raster|rays", "what a pixel sees is found by the rasteriser or by rays; deferred"},
         [](S& s, T o, T v) { s.gbuffer = parseName(kGBuffers, o, v); },
         [](C s) -> Json { return name(s.gbuffer); }},
        {{"rays", "auto|software|hardware", "rays are traced by shaders, or by the device (VK_KHR_ray_query)"},
         [](S& s, T o, T v) { s.rays = parseName(kRays, o, v); },
         [](C s) -> Json { return name(s.rays); }},
        {{"size", "WxH", "pixels"},
         [](S& s, T o, T v) { parseSize(s, o, v); },
         [](C s) -> Json { return fmt::format("{}x{}", s.width, s.height); }},
        {{"seed", "N", "the same seed gives the same bytes", 0, 100},
         [](S& s, T o, T v) { s.seed = parseInteger<uint32_t>(o, v, 0, std::numeric_limits<uint32_t>::max()); },
         [](C s) -> Json { return s.seed; }},
        {{"camera", "N", "which of the scene's cameras"},
         [](S& s, T o, T v) { s.camera = parseInteger<uint32_t>(o, v, 0, 1 << 20); },
         [](C s) -> Json { return s.camera; }},
        {{"materials", "full|diffuse", "surfaces as the scene has them, or Lambertians of the same albedo"},
         [](S& s, T o, T v) { s.materials = parseName(kMaterials, o, v); },
         [](C s) -> Json { return name(s.materials); }},
        {{"show", "picture|vpls|normal|albedo|depth|position|material|cut-off|rays",
          "the picture, the VPLs in it, a G-buffer channel, what the bound takes, or rays to VPLs: black none, red, "
          "yellow, white one for each"},
         [](S& s, T o, T v) { s.show = parseName(kShows, o, v); },
         [](C s) -> Json { return name(s.show); }},
        {{"exposure", "STOPS", "brighter by 2^STOPS in the PNG", -8, 8},
         [](S& s, T o, T v) { s.exposure = parseNumber(o, v, -64.0f, 64.0f); },
         [](C s) -> Json { return s.exposure; }},
        {{"tone-map", "linear|reinhard|aces", "tone curve of the PNG"},
         [](S& s, T o, T v) { s.toneCurve = parseName(kCurves, o, v); },
         [](C s) -> Json { return name(s.toneCurve); }},
        {{"vpl-dots", "PIXELS", "radius of the dots of --show vpls", 0.5, 20},
         [](S& s, T o, T v) { s.vplDotRadius = parseNumber(o, v, 0.5f, 100.0f); },
         [](C s) -> Json { return s.vplDotRadius; }},
        {{"plan", "on|off", "leave out what the scene does not need"},
         [](S& s, T o, T v) { s.plan = parseSwitch(o, v); },
         [](C s) -> Json { return s.plan; }},
        {{"plan-keeps", "NAME", "one thing, as --explain names it, that is kept though the scene does not need it"},
         [](S& s, T, T v) { s.planKeeps = v; },
         [](C s) -> Json { return s.planKeeps; }},
        {{"check-finite", "on|off",
          "look for infinities and NaN in what every pass wrote, and end with an error; slow"},
         [](S& s, T o, T v) { s.checkFinite = parseSwitch(o, v); },
         [](C s) -> Json { return s.checkFinite; }},
    };
    return table;
}

}  // namespace

bool resamples(const RenderSettings& settings) { return settings.castShadows && settings.shadowRays > 0; }

bool filters(const RenderSettings& settings) {
    return settings.filter != Filter::Off && (settings.interleave > 1 || resamples(settings));
}

const char* name(Technique technique) { return nameIn(kTechniques, technique); }
const char* name(Lighting lighting) { return nameIn(kLightings, lighting); }
const char* name(ClampMode clamp) { return nameIn(kClamps, clamp); }
const char* name(Materials materials) { return nameIn(kMaterials, materials); }
const char* name(Filter filter) { return nameIn(kFilters, filter); }
const char* name(Quality quality) { return nameIn(kQualities, quality); }
const char* name(Show show) { return nameIn(kShows, show); }
const char* name(ToneCurve curve) { return nameIn(kCurves, curve); }
const char* name(GBufferBy gbuffer) { return nameIn(kGBuffers, gbuffer); }
const char* name(RaysBy rays) { return nameIn(kRays, rays); }

const std::vector<SettingHelp>& settingHelps() {
    static const std::vector<SettingHelp> helps = [] {
        std::vector<SettingHelp> list;
        for (const Setting& setting : settingTable()) list.push_back(setting.help);
        return list;
    }();
    return helps;
}

bool SettingHelp::isSwitch() const { return std::string_view(values) == "on|off"; }

std::vector<std::string> SettingHelp::choices() const {
    std::vector<std::string> names;
    const std::string_view text = values;
    if (isSwitch() || text.find('|') == std::string_view::npos) return names;
    for (size_t start = 0; start <= text.size();) {
        const size_t end = std::min(text.find('|', start), text.size());
        names.emplace_back(text.substr(start, end - start));
        start = end + 1;
    }
    return names;
}

Json settingValue(const RenderSettings& settings, const std::string& option) {
    for (const Setting& setting : settingTable())
        if (option == setting.help.option) return setting.read(settings);
    failUsage("--{}: no such setting", option);
}

void applySetting(RenderSettings& settings, const std::string& option, const std::string& value) {
    for (const Setting& setting : settingTable())
        if (option == setting.help.option) return setting.apply(settings, option, value);
    failUsage("--{}: no such setting", option);
}

void applySettings(RenderSettings& settings, const Json& json, const std::string& place) {
    std::vector<std::string> keys;
    for (const auto& [key, value] : json.items()) keys.push_back(key);
    std::stable_partition(keys.begin(), keys.end(), [](const std::string& key) { return key == kPresetOption; });
    for (const std::string& key : keys) {
        const Json& value = json[key];
        if (value.is_null()) continue;
        try {
            applySetting(settings, key, value.is_string() ? value.get<std::string>() : value.dump());
        } catch (const Error& error) {
            fail("{}.{}: {}", place, key, std::string(error.what()).substr(2));
        }
    }
}

Json toJson(const RenderSettings& settings) {
    Json json = Json::object();
    for (const Setting& setting : settingTable()) json[setting.help.option] = setting.read(settings);
    return json;
}

}  // namespace manylight
