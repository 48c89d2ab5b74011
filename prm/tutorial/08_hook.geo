// Mesh of tutorial 8: a snap hook of 31 x 3 mm. Made into 08_hook.msh by
//   gmsh -2 -format msh22 08_hook.geo
// Physical curves give the boundary ids, physical surfaces the material ids.
Point(1) = {0, 0, 0, 0.8};
Point(2) = {25, 0, 0, 0.6};
Point(3) = {26, -2, 0, 0.3};
Point(4) = {27, -2, 0, 0.3};
Point(5) = {31, 0, 0, 0.5};
Point(6) = {31, 3, 0, 0.8};
Point(7) = {0, 3, 0, 0.8};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 7};
Line(7) = {7, 1};
Curve Loop(1) = {1, 2, 3, 4, 5, 6, 7};
Plane Surface(1) = {1};
Recombine Surface{1};
Mesh.RecombinationAlgorithm = 1;
Physical Curve("wall", 1) = {7};
Physical Curve("below", 2) = {1, 2, 3, 4};
Physical Curve("rest", 3) = {5, 6};
Physical Surface("hook", 1) = {1};
