// A VPL on a glossy surface: what it gives depends on where it is seen from, and the bound is on the whole product of both
// reflectances and the geometry term.
#ifndef MANYLIGHT_GLOSSY_VPLS_GLSL
#define MANYLIGHT_GLOSSY_VPLS_GLSL
#include "shaders/lib/reflected.glsl"

layout(set = 0, binding = kBindingVplGloss, rgba32f) readonly uniform imageBuffer vplGloss;

VplGloss glossFromTexels(vec4 flux, vec4 incoming, vec4 normal, vec4 diffuse, vec4 f0) {
    return VplGloss(flux.xyz, flux.w, incoming.xyz, incoming.w, normal.xyz, 0.0, diffuse.xyz, 0.0, f0.xyz, 0.0);
}

VplGloss loadGloss(uint i) {
    const int first = int(i * kTexelsPerGloss);
    return glossFromTexels(imageLoad(vplGloss, first), imageLoad(vplGloss, first + 1), imageLoad(vplGloss, first + 2),
                           imageLoad(vplGloss, first + 3), imageLoad(vplGloss, first + 4));
}

vec3 reflectanceOfVpl(VplGloss vpl, vec3 outgoing) {
    return evaluateBsdf(Bsdf(vpl.diffuse, vpl.alpha, vpl.f0, vpl.f90), vpl.normal, vpl.incoming, outgoing);
}

// What the loop over VPLs sums, without visibility: flux f_y G and, of a glossy x, f_x. Of G times the peaks of both
// reflectances the bound is left, or what it cuts off. Between Lambertians this is irradianceOfVpl(), bit for bit.
vec3 summandOfGlossyVpl(Receiver x, LightData vpl, VplGloss y, float bound, bool cutOff) {
    const vec3 toVpl = vpl.position - x.position;
    const vec3 direction = toVpl * inversesqrt(max(dot(toVpl, toVpl), 1e-30));
    const float g = geometryTerm(x.normal, vpl.direction, toVpl);
    const vec3 fy = reflectanceOfVpl(y, -direction);
    const bool isLambertian = !isGlossy(y.f90);
    const float limit = bound / (peakTowards(x, direction) * (isLambertian ? 1.0 : peak(fy)));
    const float part = cutOff ? max(g - limit, 0.0) : min(g, limit);
    const vec3 irradiance = isLambertian ? (vpl.intensity * part) * vpl.colour : part * (y.flux * fy);
    return summand(x, irradiance, direction);
}

#endif
