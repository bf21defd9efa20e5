// One of a stream of lights, drawn in proportion to what each would give without visibility, for one ray (resampling: Talbot
// et al. 2005; weighted sampling of a stream with one random number: Chao 1982).
#ifndef MANYLIGHT_RESERVOIR_GLSL
#define MANYLIGHT_RESERVOIR_GLSL
#include "shaders/lib/arriving.glsl"
#include "shaders/lib/light_samples.glsl"

const float kLargestBelowOne = 0.99999994;

struct Reservoir {
    LightData light;
    vec3 summand;
    float sumOfWeights;
    float u;  // what is left of the random number
};

Reservoir emptyReservoir(float u) { return Reservoir(lightFrom(vec3(0.0), kLightSurface), vec3(0.0), 0.0, u); }

float weightOf(vec3 summand) { return summand.x + summand.y + summand.z; }

void offer(inout Reservoir reservoir, LightData light, vec3 summand) {
    const float weight = weightOf(summand);
    reservoir.sumOfWeights += weight;
    const float probability = weight > 0.0 ? weight / reservoir.sumOfWeights : 0.0;
    const bool isTaken = reservoir.u < probability;
    const float u = isTaken ? reservoir.u / probability : (reservoir.u - probability) / (1.0 - probability);
    reservoir.u = min(u, kLargestBelowOne);
    if (!isTaken) return;
    reservoir.light = light;
    reservoir.summand = summand;
}

// An estimate of the sum of all summands that were offered, with visibility.
vec3 arrivingFrom(Reservoir reservoir, Receiver receiver) {
    const float weight = weightOf(reservoir.summand);
    const vec3 estimate = weight > 0.0 ? reservoir.summand * (reservoir.sumOfWeights / weight) : vec3(0.0);
    return arriving(estimate, receiver, reservoir.light);
}

#endif
