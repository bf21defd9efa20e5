// The cases' functions, by the file that they are in.
#pragma once

#include "apps/bench/stability/case.h"

namespace manylight::stability {

// stability_closed_forms.cpp
Findings integratingSphere(StabilityLab& lab);
Findings singlePath(StabilityLab& lab);
Findings formFactors(StabilityLab& lab);
Findings polygonLights(StabilityLab& lab);
Findings energyBalance(StabilityLab& lab);

// stability_furnace.cpp
Findings furnace(StabilityLab& lab);
Findings furnaceStiff(StabilityLab& lab);

// stability_stiff.cpp
Findings concaveCorner(StabilityLab& lab);
Findings concaveCornerQuick(StabilityLab& lab);
Findings glancing(StabilityLab& lab);
Findings keyhole(StabilityLab& lab);
Findings crackBetweenRooms(StabilityLab& lab);
Findings unequalLights(StabilityLab& lab);
Findings extremeBounds(StabilityLab& lab);

// stability_leaks.cpp
Findings thinWalls(StabilityLab& lab);
Findings nestedBoxes(StabilityLab& lab);
Findings opposedNormals(StabilityLab& lab);

// stability_units.cpp
Findings powerOfTwoUnits(StabilityLab& lab);
Findings powerOfTenUnits(StabilityLab& lab);
Findings farFromOrigin(StabilityLab& lab);
Findings farApart(StabilityLab& lab);
Findings brightAndDim(StabilityLab& lab);
Findings rangeOfFloat(StabilityLab& lab);

// stability_damage.cpp
Findings faultyEmitters(StabilityLab& lab);
Findings faultyNormals(StabilityLab& lab);
Findings faultyVertices(StabilityLab& lab);
Findings faultyAlbedos(StabilityLab& lab);
Findings untidyObj(StabilityLab& lab);
Findings injectedNan(StabilityLab& lab);

// stability_nothing.cpp
Findings nothingToSee(StabilityLab& lab);
Findings oneTriangle(StabilityLab& lab);
Findings cameraInWall(StabilityLab& lab);

// stability_coincident.cpp
Findings vplOnReceiver(StabilityLab& lab);
Findings coincidentVpls(StabilityLab& lab);
Findings coplanar(StabilityLab& lab);
Findings duplicates(StabilityLab& lab);

// stability_rays.cpp
Findings watertight(StabilityLab& lab);
Findings watertightMillion(StabilityLab& lab);
Findings signedZeros(StabilityLab& lab);
Findings oneCentroid(StabilityLab& lab);
Findings rayOffsets(StabilityLab& lab);

// stability_counts.cpp
Findings pictureSizes(StabilityLab& lab);
Findings vplCounts(StabilityLab& lab);
Findings millionVpls(StabilityLab& lab);
Findings millionsOfTriangles(StabilityLab& lab);
Findings bandsOfDispatches(StabilityLab& lab);

// stability_equivalence.cpp
Findings repeated(StabilityLab& lab);
Findings techniquesAgree(StabilityLab& lab);
Findings estimatorsAgree(StabilityLab& lab);

}  // namespace manylight::stability
