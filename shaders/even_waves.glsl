// Sines at even steps of the wavenumber, each from the one before by two additions and two products, which is a third of
// what one by itself takes; and the edges of a polygon with them. The includer includes phase.glsl first.

// sin(pi x k)/(pi x) at k = first, first + step_, ... The difference from value to value is kept for itself, so that it has
// all its digits where it is small (C. Reinsch's form of the recurrence: J. Stoer, R. Bulirsch, "Introduction to Numerical
// Analysis", 3rd ed., 2.3.2). Error: as sincOf(), and a rounding more for each step.
struct EvenSines {
    float value;
    float change;        // to the next value
    float factor;
};

// Where |x| step_ > 1 values are finite, but mean nothing: more than half a period lies between two.
EvenSines evenSines(float x, float first, float step_) {
    float half_ = min(0.5 * abs(x) * step_, 0.5);
    float sine = sinPiOverX(half_ * half_);                // of pi half_, over half_
    float middle = x * (first + 0.5 * step_), past = middle - 2.0 * roundEven(0.5 * middle), quarter = 0.5 - abs(past);
    EvenSines sines;
    sines.value = first * sincOf(x * first);
    // sin(a + b) - sin(a) = 2 sin(b/2) cos(a + b/2)
    sines.change = 0.318309886 * step_ * sine * quarter * sinPiOverX(quarter * quarter);
    sines.factor = 4.0 * half_ * half_ * sine * sine;
    return sines;
}

void toNext(inout EvenSines sines) {
    sines.value += sines.change;
    sines.change -= sines.factor * sines.value;
}

// What pairOfEdges() gives, times `weight` and the wavenumber.
struct EvenEdge {
    EvenSines along;
    EvenSines phase;
};

EvenEdge evenEdge(vec3 edge, float weight, float first, float step_) {
    EvenEdge even = EvenEdge(evenSines(edge.y, first, step_), evenSines(2.0 * edge.x, first, step_));
    float scale = 19.7392088 * edge.x * edge.z * weight;   // 2 pi^2
    even.along.value *= scale;
    even.along.change *= scale;
    return even;
}

// Leaves `even` at the next wavenumber.
float nextPairOfEdges(inout EvenEdge even) {
    float value = even.along.value * even.phase.value;
    toNext(even.along);
    toNext(even.phase);
    return value;
}
