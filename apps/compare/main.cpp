// manylight-compare: how far a picture is from its reference.
#include "apps/common/command_line.h"
#include "apps/compare/compare.h"
#include "apps/compare/limits.h"

#include <fmt/ranges.h>

int main(int argc, char** argv) {
    using namespace manylight;
    CLI::App app{"Measures how far a picture is from its reference.", "manylight-compare"};
    addStandardOptions(app);
    app.footer(
        "Examples:\n"
        "  manylight-compare picture.exr reference.exr\n"
        "  manylight-compare picture.exr reference.exr --difference difference.png --flip-map flip.png\n"
        "  manylight-compare picture.exr reference.exr --crop 0,0,256,128 --mask walls.png --json-file error.json\n"
        "  manylight-compare today.png approved.png --fail-above flip=0.02 --fail-above rmse=0.01\n"
        "Exit codes: 0 done, 1 something failed (file, pixels that are not finite, a limit), 2 wrong usage.\n"
        "docs/measuring-error.md says what the numbers mean.");

    CompareOptions options;
    app.add_option("test", options.test, "the picture: EXR (linear radiance), or PNG, JPEG, TGA, BMP (sRGB)")
        ->type_name("FILE")
        ->required();
    app.add_option("reference", options.reference, "what it should be: of the same kind and size")
        ->type_name("FILE")
        ->required();
    app.add_option("--layer", options.layer, "compare this layer of the EXR files, not the main image")
        ->type_name("NAME");
    app.add_option("--mask", options.mask, "picture of the same size: only pixels that are not black in it count")
        ->type_name("FILE");
    app.add_option("--crop", options.crop, "compare this rectangle only, as if it were cut out")->type_name("X,Y,W,H");
    app.add_option("--flip", options.flip, "auto: hdr for EXR, ldr for PNG and the like")
        ->transform(CLI::CheckedTransformer(std::map<std::string, FlipKind>{
            {"auto", FlipKind::Auto}, {"hdr", FlipKind::Hdr}, {"ldr", FlipKind::Ldr}, {"off", FlipKind::Off}}))
        ->option_text("auto|hdr|ldr|off [auto]");
    app.add_option("--pixels-per-degree", options.pixelsPerDegree, "for FLIP: of the screen as the eye sees it")
        ->check(CLI::Range(kMinPixelsPerDegree, kMaxPixelsPerDegree))
        ->option_text("N [67.02]");
    app.add_option("--fail-above", options.failAbove,
                   fmt::format("end with code 1 if it is larger; may be repeated. {}", fmt::join(limitNames(), "|")))
        ->type_name("NUMBER=VALUE")
        ->allow_extra_args(false);  // or it would swallow the pictures
    app.add_flag("--allow-nonfinite", options.allowNonFinite, "do not fail because of pixels that are not finite");
    app.add_flag("--json", options.json, "print JSON instead of the table")->group("Output");
    app.add_option("--json-file", options.jsonFile, "write the JSON")->type_name("FILE")->group("Output");
    app.add_option("--difference", options.difference, "relative error in false colour: blue darker, red brighter")
        ->type_name("FILE.png")
        ->group("Output");
    app.add_option("--difference-range", options.differenceRange, "relative error at the scale's ends, 0.1 for 10 %")
        ->check(CLI::PositiveNumber)
        ->type_name("X")
        ->group("Output");
    app.add_option("--flip-map", options.flipMap, "FLIP's error map in its colours")
        ->type_name("FILE.png")
        ->group("Output");

    return runProgram(app, argc, argv, [&] { compare(options); });
}
