// Every choice a user has, in one plain struct: the command line, the sidecar and the programs fill it.
#pragma once

#include "engine/core/report.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

namespace manylight {

enum class Technique : uint8_t {
    Deferred,        // G-buffer, then compute passes light every visible point
    Forward,         // the fragment shader lights every fragment
    ForwardPrepass,  // the same after a depth pre-pass
    PathTracer,      // the reference
};

enum class Lighting : uint8_t {
    Local,   // emission and direct light
    Global,  // light from the VPLs only
    Both,
};

enum class ClampMode : uint8_t {
    Off,         // the geometry term as it is: unbiased, without a variance: bright spots near VPLs, errors of N^(-1/3)
    Bound,       // cut at bound * N^(2/3) / area: loses energy, vanishing as paths accumulate
    Compensate,  // cut at bound / area, and given back by short paths: unbiased, without the bright spots
};

enum class Materials : uint8_t {
    Full,
    Diffuse,  // every surface a Lambertian of its albedo, for comparison with what knows no others
};

enum class Filter : uint8_t {
    Off,
    Atrous,  // edge-avoiding wavelet after an interleaved or resampled gather; fades as frames come in
    Ratio,   // the same of the share of the light that arrives, times the light as if nothing were between
};

enum class Quality : uint8_t { Draft, Interactive, Final };

enum class Show : uint8_t { Picture, Vpls, Normal, Albedo, Depth, Position, Material, CutOff, Rays };

enum class GBufferBy : uint8_t {
    Auto,    // as is faster here
    Raster,  // the rasteriser
    Rays,    // a ray through every pixel
};

enum class RaysBy : uint8_t {
    Auto,      // hardware, unless a CPU would play it
    Software,  // the traversal in the shaders
    Hardware,  // the device: VK_KHR_ray_query
};

enum class ToneCurve : uint8_t { Linear, Reinhard, Aces };

struct RenderSettings {
    Technique technique = Technique::Deferred;
    Lighting lighting = Lighting::Both;
    ClampMode clamp = ClampMode::Off;
    Materials materials = Materials::Full;
    Show show = Show::Picture;
    ToneCurve toneCurve = ToneCurve::Aces;
    GBufferBy gbuffer = GBufferBy::Auto;
    RaysBy rays = RaysBy::Auto;
    uint32_t width = 0;  // pixels; 0: as the scene's camera says, else 512 x 384
    uint32_t height = 0;
    uint32_t vplCount = 800;         // VPLs shaded in every frame; 0: none
    uint32_t pathCount = 0;          // light paths per frame; 0: defaultPathCount() of the VPLs
    std::optional<int> bounceCount;  // surfaces a light path may meet; empty: the scene's max_depth; -1: unlimited
    bool russianRoulette = true;
    bool castShadows = true;
    uint32_t shadowRays = 0;       // of a pixel for all its VPLs, drawn by what they would give; 0: one for each
    uint32_t interleave = 1;       // n: a pixel gathers from one VPL in n * n, neighbours from others
    uint32_t interleavePhase = 0;  // which, in the first frame
    Filter filter = Filter::Off;
    uint32_t gatherStep = 1;           // with a filter: every so many pixels gather, the others ask them
    uint32_t visibilitySamples = 1;    // with a filter: points of a pixel where a frame asks what is seen
    Quality quality = Quality::Final;  // the preset that set some of these; what is set later counts
    std::optional<float> clampBound;   // c of the bound; empty: as suits the mode
    uint32_t lightSampleCount = 16;    // points on area lights and the environment per pixel and frame
    uint32_t seed = 0;
    uint32_t camera = 0;             // index into the scene's cameras
    float exposure = 0.0f;           // stops
    float vplDotRadius = 3.0f;       // --show vpls, pixels
    bool continuesSequences = true;  // frames draw from one sequence; otherwise each is a sample of its own
    bool jitter = false;             // a new place in the pixel for every frame: the 1 x 1 box filter
    bool temporal = false;           // light of earlier views stands in for frames to come
    bool plan = true;                // leave out what the scene does not need
    std::string planKeeps;           // but for one thing, named as in the plan's decisions; for measuring what it costs
    bool checkFinite = false;        // look at what every pass wrote; slow

    bool operator==(const RenderSettings&) const = default;
};

/// Whether pixels draw few of their VPLs for shadow rays, by what each would give.
bool resamples(const RenderSettings& settings);
/// Whether light is filtered: a filter follows interleaved gathers and those of few rays.
bool filters(const RenderSettings& settings);

/// Names as the command line spells them, e.g. "forward-prepass".
const char* name(Technique technique);
const char* name(Lighting lighting);
const char* name(ClampMode clamp);
const char* name(Materials materials);
const char* name(Filter filter);
const char* name(Quality quality);
const char* name(Show show);
const char* name(ToneCurve curve);
const char* name(GBufferBy gbuffer);
const char* name(RaysBy rays);
/// Sets one setting by its option name without dashes ("vpls", "shadows"), from text. Throws Error (usage) naming the
/// option, the value and what was expected.
void applySetting(RenderSettings& settings, const std::string& option, const std::string& value);
/// This option sets several others: of options given together it is to be applied first, so that the others count.
inline constexpr const char* kPresetOption = "quality";
/// What a user is told of a setting: the one description that command lines, sidecars and panels are made from.
struct SettingHelp {
    const char* option;
    const char* values;  // "on|off", "a|b|c" for a choice, otherwise what to write: "N", "WxH"
    const char* help;
    double sliderLow = 0.0;  // the range that people want; applySetting() takes more. Equal: no slider.
    double sliderHigh = 0.0;

    bool isSwitch() const;
    /// The names to choose from; none for a switch or a number.
    std::vector<std::string> choices() const;
};
const std::vector<SettingHelp>& settingHelps();
/// The value that applySetting() would need to set it again; null where it follows from others.
Json settingValue(const RenderSettings& settings, const std::string& option);

/// Applies a sidecar's "settings" object: {"vpls": 200, "shadows": false}; null changes nothing. `place` prefixes error
/// messages.
void applySettings(RenderSettings& settings, const Json& json, const std::string& place);

/// All settings, for the run report and the EXR's attributes.
Json toJson(const RenderSettings& settings);

/// Four for each VPL, but at least 256, and 6400 at most or one for each: paths cost little beside what their VPLs cost
/// to shade, and a sample from more of them scatters less; of many VPLs each path gives several.
constexpr uint64_t defaultPathCount(uint64_t vplCount) {
    return std::max({std::min(4 * vplCount, uint64_t{6400}), vplCount, uint64_t{256}});
}

/// "Unlimited" light paths end between these two, the earlier the darker the scene; the paths cut off are reported.
inline constexpr uint32_t kUnlimitedBounces = 64;
inline constexpr uint32_t kMaxBounces = 1024;

}  // namespace manylight
