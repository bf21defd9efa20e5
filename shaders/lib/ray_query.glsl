// occluded() and closestHit() of bvh.glsl, by the device: VK_KHR_ray_query. Its triangles are in leaf order too, and its
// instances are those of instances.glsl, so that both ways count alike.
#ifndef MANYLIGHT_RAY_QUERY_GLSL
#define MANYLIGHT_RAY_QUERY_GLSL

layout(set = 0, binding = kBindingAccelerationStructure) uniform accelerationStructureEXT sceneStructure;

struct DeviceHit {
    bool isHit;
    uint instance;  // 0 where every triangle is in the scene's frame
    uint place;     // where the triangle is stored
    float t;
    vec2 barycentrics;
};

uint placeIn(uint instance, uint primitive) {
    if (kInstanced == 0u) return primitive;
    return firstNumberOf(instance) + primitive - numberOffsetOf(instance);
}

// A triangle at t in (0, tMax): the nearest, or with gl_RayFlagsTerminateOnFirstHitEXT any.
DeviceHit hitByDevice(vec3 origin, vec3 direction, float tMax, uint flags) {
    DeviceHit hit = DeviceHit(false, 0u, 0u, tMax, vec2(0.0f));
    if (direction == vec3(0.0f) || !(tMax > 0.0f)) return hit;
    rayQueryEXT query;
    rayQueryInitializeEXT(query, sceneStructure, kAlphaTested ? flags : flags | gl_RayFlagsOpaqueEXT, 0xffu, origin,
                          0.0f, direction, tMax);
    const uint number = kAlphaTested ? numberOfRay(origin, direction) : 0u;
    bool isAtCandidate = rayQueryProceedEXT(query);
    while (isAtCandidate) {
        // The device stops at triangles that may let light through.
        if (kAlphaTested) {
            const uint instance = uint(rayQueryGetIntersectionInstanceIdEXT(query, false));
            const uint place = placeIn(instance, uint(rayQueryGetIntersectionPrimitiveIndexEXT(query, false)));
            const uint ray = kInstanced == 0u ? number : number + numberOffsetOf(instance);
            if (!letsThrough(place, rayQueryGetIntersectionBarycentricsEXT(query, false), ray))
                rayQueryConfirmIntersectionEXT(query);
        }
        isAtCandidate = rayQueryProceedEXT(query);
    }
    bvhLoopBudgetExceeded = bvhLoopBudgetExceeded || isAtCandidate;
    if (rayQueryGetIntersectionTypeEXT(query, true) != gl_RayQueryCommittedIntersectionTriangleEXT) return hit;
    hit.isHit = true;
    hit.instance = uint(rayQueryGetIntersectionInstanceIdEXT(query, true));
    hit.place = placeIn(hit.instance, uint(rayQueryGetIntersectionPrimitiveIndexEXT(query, true)));
    hit.t = rayQueryGetIntersectionTEXT(query, true);
    hit.barycentrics = rayQueryGetIntersectionBarycentricsEXT(query, true);
    return hit;
}

// Is there a triangle at t in (0, tMax)? A zero direction meets nothing.
bool occluded(vec3 origin, vec3 direction, float tMax) {
    return hitByDevice(origin, direction, tMax, gl_RayFlagsTerminateOnFirstHitEXT).isHit;
}

// The nearest triangle at t in (0, tMax); of several at the same t any. Which one is up to the device; where on it is
// computed as in the other traversal, so that pictures agree to rounding.
Hit closestHit(vec3 origin, vec3 direction, float tMax) {
    const DeviceHit found = hitByDevice(origin, direction, tMax, gl_RayFlagsNoneEXT);
    if (!found.isHit) return Hit(tMax, kNoHit, vec2(0.0f));
    TriangleHit own;
    uint offset = 0u;
    if (kInstanced == 0u) {
        own = testTriangle(makeTraversalRay(origin, direction), found.place, tMax);
    } else {
        own = testTriangle(rayInMesh(found.instance, origin, direction), found.place, tMax);
        offset = numberOffsetOf(found.instance);
        rememberInstance(found.instance);
    }
    return Hit(own.isHit ? own.t : found.t, found.place + offset, own.isHit ? own.barycentrics : found.barycentrics);
}

#endif
