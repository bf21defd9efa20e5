// A fixed piece of work in plain C++, timed beside the measurements: where it varies, the machine does.
#pragma once

namespace manylight {

/// Milliseconds that one thread takes for a fixed loop of dependent integer and float operations: the median of three.
double calibrationMilliseconds();

}  // namespace manylight
