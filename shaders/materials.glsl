// What surfaces do to light: Fresnel's equations for metals and glass (unpolarised).

// Reflectance of a metal with complex refractive index n + i k, seen under cosTheta
// (Born & Wolf, Principles of Optics, 14.4; the closed form over real numbers).
float fresnelConductor(float cosTheta, float n, float k) {
    float cos2 = cosTheta * cosTheta;
    float sin2 = (1.0 - cosTheta) * (1.0 + cosTheta);      // 1 - cos^2 loses digits
    float difference = n * n - k * k - sin2;
    float a2PlusB2 = sqrt(difference * difference + 4.0 * n * n * k * k);
    // a^2 - b^2 is the difference, and a b = n k: the larger of both first, so that no digits cancel.
    float larger = 0.5 * (a2PlusB2 + abs(difference));
    float a = sqrt(difference >= 0.0 ? larger : n * n * k * k / larger);
    float s1 = a2PlusB2 + cos2;
    float s2 = 2.0 * cosTheta * a;
    float rs = (s1 - s2) / (s1 + s2);
    float p1 = cos2 * a2PlusB2 + sin2 * sin2;
    float p2 = s2 * sin2;
    float rp = rs * (p1 - p2) / (p1 + p2);
    return 0.5 * (rs + rp);
}

// Reflectance of an interface; `eta` is the index behind it over the index before it. 1 in total internal reflection,
// else cosTransmitted is set.
float fresnelDielectric(float cosIncident, float eta, out float cosTransmitted) {
    float sin2 = (1.0 - cosIncident) * (1.0 + cosIncident) / (eta * eta);   // 1 - cos^2 loses digits
    cosTransmitted = sqrt(max(1.0 - sin2, 0.0));
    if (sin2 >= 1.0) return 1.0;
    float rs = (cosIncident - eta * cosTransmitted) / (cosIncident + eta * cosTransmitted);
    float rp = (eta * cosIncident - cosTransmitted) / (eta * cosIncident + cosTransmitted);
    return 0.5 * (rs * rs + rp * rp);
}
