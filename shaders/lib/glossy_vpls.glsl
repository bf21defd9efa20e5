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

// Share of a connection that the bound leaves; `product` is the geometry term times the peaks of both reflectances.
float shareWithin(float bound, float product) { return product > bound ? bound / product : 1.0; }

// Radiance towards the viewer, without visibility: flux f_y f_x G, of which the bound leaves its share, or cuts it off.
vec3 radianceOfGlossyVpl(Receiver x, LightData vpl, VplGloss y, float bound, bool cutOff) {
    const vec3 toVpl = vpl.position - x.position;
    const vec3 direction = toVpl * inversesqrt(max(dot(toVpl, toVpl), 1e-30));
    const float g = geometryTerm(x.normal, vpl.direction, toVpl);
    const vec3 fx = evaluateBsdf(x.bsdf, x.normal, direction, x.toViewer);
    const vec3 fy = reflectanceOfVpl(y, -direction);
    const float share = shareWithin(bound, g * peak(fx) * peak(fy));
    return (g * (cutOff ? 1.0 - share : share)) * (y.flux * fy * fx);
}

#endif
