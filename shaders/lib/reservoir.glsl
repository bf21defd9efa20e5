// One of a stream of lights, for one ray: drawn in proportion to what each would give without visibility (resampling: Talbot
// et al. 2005; weighted sampling of a stream with one random number: Chao 1982), or, for a share of the draws, all alike
// (a defensive mixture: Hesterberg 1995). A strong light behind a wall would leave next to no draws to a weak one else.
#ifndef MANYLIGHT_RESERVOIR_GLSL
#define MANYLIGHT_RESERVOIR_GLSL
#include "shaders/lib/arriving.glsl"
#include "shaders/lib/light_samples.glsl"

const float kLargestBelowOne = 0.99999994;
const float kDefensiveShare = 0.1;

struct Reservoir {
    LightData light;
    vec3 summand;
    float sumOfWeights;
    float count;      // of lights that give something
    bool takesAlike;
    float u;          // what is left of the random number
};

// Both of what a random number leaves are random numbers again.
float restOf(float u, float probability, bool isBelow) {
    return min(isBelow ? u / probability : (u - probability) / (1.0 - probability), kLargestBelowOne);
}

Reservoir emptyReservoir(float u) {
    const bool takesAlike = u < kDefensiveShare;
    return Reservoir(lightFrom(vec3(0.0), kLightSurface), vec3(0.0), 0.0, 0.0, takesAlike,
                     restOf(u, kDefensiveShare, takesAlike));
}

float weightOf(vec3 summand) { return summand.x + summand.y + summand.z; }

void offer(inout Reservoir reservoir, LightData light, vec3 summand) {
    const float weight = weightOf(summand);
    reservoir.sumOfWeights += weight;
    if (weight > 0.0) reservoir.count += 1.0;
    const float share = reservoir.takesAlike ? 1.0 / reservoir.count : weight / reservoir.sumOfWeights;
    const float probability = weight > 0.0 ? share : 0.0;
    const bool isTaken = reservoir.u < probability;
    reservoir.u = restOf(reservoir.u, probability, isTaken);
    if (!isTaken) return;
    reservoir.light = light;
    reservoir.summand = summand;
}

// An estimate of the sum of all summands that were offered, with visibility.
vec3 arrivingFrom(Reservoir reservoir, Receiver receiver) {
    const float weight = weightOf(reservoir.summand);
    const float density = mix(weight / reservoir.sumOfWeights, 1.0 / reservoir.count, kDefensiveShare);
    const vec3 estimate = weight > 0.0 ? reservoir.summand / density : vec3(0.0);
    return arriving(estimate, receiver, reservoir.light);
}

#endif
