// Branches and loops that hang on specialisation constants (live_code_test.cpp says what should come out).
#version 460
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 1) in;
layout(constant_id = 0) const uint COUNT = 1u;
layout(constant_id = 1) const uint KIND = 0u;
layout(constant_id = 2) const bool HAS_IT = false;

layout(scalar, set = 0, binding = 0) uniform Block { uint given; };
layout(scalar, set = 0, binding = 1) buffer Result { uint words[]; };

// Not inlined, with an early return.
uint steps(uint n) {
    for (uint i = 0u; i < 100u; ++i) {
        if (HAS_IT && i == 3u) return 1000u + i;
        if (n <= 1u) return i;
        n = n % 2u == 0u ? n / 2u : 3u * n + 1u;
    }
    return 100u;
}

void main() {
    for (uint i = 0u; i < 12u; ++i) words[i] = 0u;

    // One side, both sides, and a value that depends on the side.
    uint value = 7u;
    if (KIND == 1u) value += given;
    words[0] = value;
    if (HAS_IT) value *= 3u;
    else value += 100u;
    words[1] = value;
    words[2] = KIND != 0u && given > 2u ? 5u : 6u;
    words[3] = HAS_IT || given > 100u ? 8u : 9u;

    // Loops: of no turns; one that always ends in its first turn; one that skips.
    uint sum = 0u;
    for (uint i = 0u; i < COUNT; ++i) {
        if (KIND == 2u) continue;
        if (i + given > 12u) break;
        sum += i + given;
    }
    words[4] = sum;
    for (uint i = 0u; i < given; ++i) {
        sum += 10u * i;
        if (HAS_IT) break;
        for (uint j = 0u; j < COUNT; ++j) sum += j;
    }
    words[5] = sum;
    uint turns = 0u;
    do {
        ++turns;
    } while (HAS_IT && turns < given);
    words[6] = turns;

    switch (KIND) {
        case 0u:
            words[7] = given;
            break;
        case 1u:
            words[7] = 2u * given;
        case 2u:
            words[8] = 3u * given;
            break;
        default:
            words[7] = 4u;
    }
    words[9] = steps(given);
    if (HAS_IT) words[10] = steps(given + 1u);
    if (KIND == 3u) return;
    words[11] = 1u;
}
