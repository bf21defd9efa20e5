// Instant radiosity's shading (Keller 1997): what one light gives to one surface, and the loop over many.
#ifndef MANYLIGHT_VPL_SHADING_GLSL
#define MANYLIGHT_VPL_SHADING_GLSL
#include "shaders/lib/range.glsl"
#include "shaders/lib/spot.glsl"
#include "shaders/shared/bsdf.h"
#include "shaders/shared/lights.h"

// What a receiver needs to know of itself. Both normals are on the viewer's side; light from the other side of the
// geometric one does not arrive, whatever the shading normal says.
struct Receiver {
    vec3 position;
    vec3 normal;
    vec3 geometricNormal;
    vec3 toViewer;  // unit
    Bsdf bsdf;
};

// G(x,y) = cos+ cos+ / d^2, from the unnormalised connection: one division and no root. d^2 of coincident points is 0,
// and so are both cosines: the guard keeps 0/0 out.
float geometryTerm(vec3 receiverNormal, vec3 emitterNormal, vec3 toEmitter) {
    const float inverseSquare = 1.0f / max(dot(toEmitter, toEmitter), 1e-30f);
    const float cosReceiver = max(dot(receiverNormal, toEmitter), 0.0f);
    const float cosEmitter = max(-dot(emitterNormal, toEmitter), 0.0f);
    return (cosReceiver * inverseSquare) * (cosEmitter * inverseSquare);
}

// Irradiance at the receiver from a VPL, without visibility: intensity * min(G, bound).
vec3 irradianceOfVpl(Receiver receiver, LightData vpl, float bound) {
    const float g = geometryTerm(receiver.normal, vpl.direction, vpl.position - receiver.position);
    return (vpl.intensity * min(g, bound)) * vpl.colour;
}

// What that bound cuts off.
vec3 irradianceCutOff(Receiver receiver, LightData vpl, float bound) {
    const float g = geometryTerm(receiver.normal, vpl.direction, vpl.position - receiver.position);
    return (vpl.intensity * max(g - bound, 0.0f)) * vpl.colour;
}

// Irradiance at the receiver from any light, without visibility. The bound is for VPLs only: here nothing is cut.
vec3 irradianceOfLight(Receiver receiver, LightData light) {
    const vec3 spectrum = light.intensity * light.colour;
    if (light.kind == kLightDirectional) return spectrum * max(-dot(receiver.normal, light.direction), 0.0f);
    const vec3 toLight = light.position - receiver.position;
    if (light.kind == kLightSurface) return spectrum * geometryTerm(receiver.normal, light.direction, toLight);
    const float squaredDistance = max(dot(toLight, toLight), 1e-30f);
    const vec3 direction = toLight * inversesqrt(squaredDistance);
    const float emission =
        light.kind == kLightSpot ? spotFalloff(-dot(direction, light.direction), light.cosBeam, light.cosCutoff) : 1.0f;
    const float window = rangeWindow(sqrt(squaredDistance), light.inverseRange);
    return spectrum * (window * emission * max(dot(receiver.normal, direction), 0.0f) / squaredDistance);
}

#endif
