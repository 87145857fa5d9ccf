// The geometry, camera and lamp of scenes/thesis/figure-24.json, without its gratings: what POV-Ray is timed on.
#version 3.7;

global_settings { assumed_gamma 1.0 }

camera {
    location <-0.45, 0.1, 3.3>
    right -x  // right-handed, as Fringe is
    up y
    angle 38  // across; the picture is square, so it is Fringe's vertical angle too
    look_at <0.12, -0.02, -0.4>
}

light_source { <0, 0.9, 0.3> color rgb 1 }

#macro Wall(Corner, U, V, Colour)
    polygon {
        5, Corner, Corner + U, Corner + U + V, Corner + V, Corner
        pigment { color rgb Colour }
        finish { ambient 0 diffuse 1 }
    }
#end

#declare White = <0.75, 0.75, 0.75>;
Wall(<-1, -1, -1>, 2*x, 2*y, White)                // back wall
Wall(<-1, -1, -1>, 2*x, 2*z, White)                // floor
Wall(<-1, 1, -1>, 2*x, 2*z, White)                 // ceiling
Wall(<-1, -1, -1>, 2*y, 2*z, <0.6, 0.06, 0.05>)    // left wall
Wall(<1, -1, -1>, 2*y, 2*z, <0.12, 0.45, 0.1>)     // right wall
