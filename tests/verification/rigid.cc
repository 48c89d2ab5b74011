// SPDX-License-Identifier: LGPL-2.1-or-later

// Rigid bodies that forces move.

#include "../support/run_scene.h"

#include <cmath>
#include <iostream>

using namespace Test;


// A plate on a nearly rigid block is a plate on springs k = alpha K/l = 1000
// per area of the width 2: it sinks by F/(2 k) and turns by 12 M/(8 k).
TEST(Rigid, PlateSinksAndTurnsAsOnSprings)
{
  const auto s = run<2>(
    names("block", "base", "i") +
    body("block",
         "Lower corner = -1,0|Upper corner = 1,1|Cells = 16,2",
         "Law = linear elastic|Young's modulus = 1e9|Poisson's ratio = 0") +
    rigid("plate",
          "Type = plane|Axis = 0,-1|Position = 0,1|Free motions = y, "
          "rotation|Force y = -20*t|Moment z = t") +
    condition("base", "Body = block|Boundary ids = 2|x = 0|y = 0") +
    interface("i",
              "Secondary = block: boundary 3|Primary = plate|Law = "
              "linear|Stiffness = 1000|Characteristic length = 0.1|Secondary "
              "offset = 1e-6|Initial penetration = ignore|Initial pressure = "
              "1e-3|Release = report") +
    solver(1e-8, 0.5));
  const auto &r = s->model.interfaces[0]->report();
  EXPECT_NEAR(r.force[1], -20., 1e-6);
  std::ifstream history(s->scene.output.directory + "/history.csv");
  std::string   names_line, line, cell;
  std::getline(history, names_line);
  while (history.peek() != EOF)
    std::getline(history, line);
  std::istringstream columns(names_line), values(line);
  double             sink = 0., turn = 0.;
  std::string        value;
  while (std::getline(columns, cell, ',') && std::getline(values, value, ','))
    {
      if (cell == "rigid:plate_motion_y")
        sink = std::stod(value);
      if (cell == "rigid:plate_rotation_z")
        turn = std::stod(value);
    }
  EXPECT_NEAR(sink, -20. / 2000., 1e-3 * 0.01);
  EXPECT_NEAR(turn, 12. / 8000., 1e-3 * 0.0015);
}


namespace
{
  /// Root mean square of what a running mean leaves of the force, over the
  /// mean, while a polygon of 24
  /// sides slides over a block.
  double
  ripple_of_disc(const std::string &smooth)
  {
    std::ofstream file("disc.msh");
    file.precision(17);
    const unsigned int n = 24;
    file << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << n << "\n";
    for (unsigned int i = 0; i < n; ++i)
      file << i + 1 << " " << std::cos(2. * numbers::PI * i / n) << " "
           << std::sin(2. * numbers::PI * i / n) << " 0\n";
    file << "$EndNodes\n$Elements\n" << n << "\n";
    for (unsigned int i = 0; i < n; ++i)
      file << i + 1 << " 1 2 1 1 " << i + 1 << " " << (i + 1) % n + 1 << "\n";
    file << "$EndElements\n";
    file.close();

    Log  log(MPI_COMM_WORLD, true);
    auto s = make<2>(
      names("block", "base", "i") +
        body("block",
             "Lower corner = 0,0|Upper corner = 4,1|Cells = 60,12",
             "Young's modulus = 1000|Poisson's ratio = 0.3") +
        rigid("disc",
              "Type = mesh|File = disc.msh|Position = 1.3, 2|Smooth = " +
                smooth +
                "|Move x = if(t<1, 0, 1.2*(t-1))|Move y = -0.08*if(t<1, t, "
                "1)") +
        condition("base", "Body = block|Boundary ids = 2|x = 0|y = 0") +
        interface("i",
                  "Secondary = block: boundary 3|Primary = disc|Kind = forming "
                  "surface to surface|Stiffness scale = 20|Release = report") +
        solver(1e-8, 0.02) +
        section("Steps", "End time = 2|First step = 0.02|Times to meet = 1"),
      log);
    std::vector<double> forces;
    s->after_step = [&](Simulation<2> &now) {
      if (now.time > 1.01)
        forces.push_back(now.model.interfaces[0]->report().force[1]);
    };
    EXPECT_EQ(s->run(), finished);
    // against the mean over 7 samples to each side
    const int half = 7, n_forces = forces.size();
    double    squares = 0., sum = 0.;
    int       count = 0;
    for (int i = half; i + half < n_forces; ++i, ++count)
      {
        double mean = 0.;
        for (int k = i - half; k <= i + half; ++k)
          mean += forces[k] / (2 * half + 1);
        squares += (forces[i] - mean) * (forces[i] - mean);
        sum += std::abs(mean);
      }
    return std::sqrt(squares * count) / sum;
  }
} // namespace


// SHELL_AND_FLUID 6.4: facet normals of a coarse round tool make most of the
// ripple; patches across vertex normals take it away.
TEST(Rigid, SmoothedFacetsOfACoarseToolSlideWithLessRipple)
{
  const double facets = ripple_of_disc("no");
  const double smooth = ripple_of_disc("yes");
  std::cout << "ripple: facets " << facets << ", smoothed " << smooth
            << std::endl;
  EXPECT_LT(2. * smooth, facets);
}
