// Reads a uniform block in every way that withConstantBlock() knows, and writes what it read, 13 words per
// invocation (constant_block_test.cpp says which).
#version 460
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 4) in;
layout(constant_id = 0) const uint LAST = 1u;

struct Inner {
    uint kind;
    vec3 direction;
};

struct Outer {
    float scale;
    Inner inner[4];
    uvec4 counts;
};

layout(scalar, set = 0, binding = 0) uniform Block {
    Outer outer[2];
    int lowest;
    float zeros[6];
    float spread[4];
} block;

layout(scalar, set = 0, binding = 1) buffer Result { uint words[]; };

uint at = gl_GlobalInvocationID.x * 13u;

void put(uint word) { words[at++] = word; }
void put(float value) { put(floatBitsToUint(value)); }

void main() {
    uint i = gl_GlobalInvocationID.x;
    put(uint(block.lowest));                           // constant places
    put(block.outer[1].scale);
    put(block.outer[1].inner[2].direction.y);
    put(block.outer[LAST].counts.z);                   // a specialisation constant
    put(block.spread[i]);                              // an index of the invocation
    put(block.zeros[i]);
    put(block.outer[0].inner[i].direction.x);          // ... then a constant one
    put(block.outer[i & 1u].inner[3u - i].kind);       // two of them
    put(block.outer[0].counts[i]);                     // a component
    Inner whole = block.outer[1].inner[i];             // a struct
    put(whole.direction.z);
    Outer largest = block.outer[1];
    put(largest.inner[1].kind);
    float sum = 0.0;                                   // a loop's index
    for (int j = 0; j < 3; ++j) sum += block.spread[j];
    put(sum);
    vec3 direction = block.outer[i >> 1].inner[0].direction;
    put(direction.x + direction.y);
}
