// What the probes of `fringe stress` share: an evaluation's inputs lie one after another, so do its results.
layout(local_size_x = 64) in;
layout(constant_id = 0) const uint VARIANT = 0u;   // which function
layout(constant_id = 1) const uint INPUTS = 1u;    // floats that an evaluation takes
layout(constant_id = 2) const uint RESULTS = 1u;   // floats that it gives
layout(scalar, set = 0, binding = 0) readonly buffer InputBlock { float inputs[]; };
layout(scalar, set = 0, binding = 1) writeonly buffer ResultBlock { float results[]; };

float given(uint i) { return inputs[gl_GlobalInvocationID.x * INPUTS + i]; }
vec2 given2(uint i) { return vec2(given(i), given(i + 1u)); }
vec3 given3(uint i) { return vec3(given(i), given(i + 1u), given(i + 2u)); }
vec4 given4(uint i) { return vec4(given2(i), given2(i + 2u)); }
void give(uint i, float value) { results[gl_GlobalInvocationID.x * RESULTS + i] = value; }
