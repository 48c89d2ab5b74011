// SPDX-License-Identifier: LGPL-2.1-or-later

// Fluid, leaflets and contact together. References: mirror symmetry, the
// volume that is kept, finer meshes and steps, a run without a break.

#include "immersed/immersed_flow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

using namespace Immersed;

namespace
{
  /// prm/immersed_leaflets.prm, coarse.
  Parameters
  closing_valve(const std::string &directory)
  {
    ParameterHandler prm;
    Parameters::declare(prm);
    prm.declare_entry("Driver", "", Patterns::Anything());
    prm.parse_input(std::string(MORTAR_CONTACT_SOURCE_DIR) +
                    "/prm/immersed_leaflets.prm");
    prm.enter_subsection("Channel");
    prm.set("Cells", std::string("20, 8"));
    prm.set("Refinements", 1L);
    prm.leave_subsection();
    prm.enter_subsection("Leaflets");
    prm.set("Cells", 16L);
    prm.leave_subsection();
    prm.enter_subsection("Steps");
    prm.set("First step", 0.02);
    prm.leave_subsection();
    prm.enter_subsection("Output");
    prm.set("Directory", directory);
    prm.set("Every", 0L);
    prm.leave_subsection();
    Parameters parameters;
    parameters.read(prm);
    return parameters;
  }

  std::vector<std::vector<double>>
  history(const std::string &directory, std::vector<std::string> &names)
  {
    std::ifstream                    in(directory + "/history.csv");
    std::string                      line;
    std::vector<std::vector<double>> rows;
    std::getline(in, line);
    names = Utilities::split_string_list(line, ',');
    while (std::getline(in, line))
      rows.push_back(
        Utilities::string_to_double(Utilities::split_string_list(line, ',')));
    return rows;
  }

  unsigned int
  column(const std::vector<std::string> &names, const std::string &name)
  {
    const auto at = std::find(names.begin(), names.end(), name);
    EXPECT_NE(at, names.end()) << name;
    return at - names.begin();
  }
} // namespace


// Opens, closes, holds the pressure: leaflets meet, the flow back stops, the
// two stay mirror images of each other, what comes in goes out.
TEST(ImmersedValve, OpensClosesAndHolds)
{
  const std::string folder = "output-immersed-valve";
  Structure::Log    log(MPI_COMM_SELF, true);
  ImmersedFlow      valve(closing_valve(folder), "", log);
  ASSERT_EQ(valve.run(), Structure::finished);
  std::vector<std::string> names;
  const auto               rows  = history(folder, names);
  const unsigned int       in    = column(names, "inflow");
  const unsigned int       out   = column(names, "outflow");
  const unsigned int       pairs = column(names, "contact:active_pairs");
  const unsigned int       deepest =
    column(names, "contact:penetration_over_release");
  const unsigned int first = column(names, "leaflet_0:tip_x");
  double             most = 0., largest_gap = 0.;
  for (const auto &row : rows)
    {
      most = std::max(most, row[in]);
      // mirror images
      EXPECT_NEAR(row[first], row[first + 2], 1e-6);
      EXPECT_NEAR(row[first + 1] + row[first + 3], 1.61, 1e-6);
      EXPECT_NEAR(row[in], row[out], 1e-6 * std::max(1., most));
      largest_gap = std::max(largest_gap, row[first + 3] - row[first + 1]);
      EXPECT_LT(row[deepest], 0.9);
    }
  const auto &last = rows.back();
  EXPECT_GT(largest_gap, 0.3); // opened
  EXPECT_GT(most, 0.5);        // flow forth
  EXPECT_GT(last[pairs], 0.);  // closed
  // spring and mass have swung out
  EXPECT_LT(std::abs(last[in]), 0.02 * most);
}


// A run that was saved and goes on gives the numbers of one that was not.
TEST(ImmersedValve, GoesOnFromACheckpoint)
{
  const std::string whole = "output-immersed-whole",
                    half  = "output-immersed-half";
  Structure::Log log(MPI_COMM_SELF, true);
  Parameters     parameters = closing_valve(whole);
  parameters.end_time       = 0.24;
  parameters.refine_every   = 4;
  ImmersedFlow one(parameters, "", log);
  ASSERT_EQ(one.run(), Structure::finished);
  parameters.directory = half;
  parameters.end_time  = 0.12;
  {
    ImmersedFlow first(parameters, "", log);
    ASSERT_EQ(first.run(), Structure::finished);
  }
  parameters.end_time = 0.24;
  ImmersedFlow second(parameters, "", log);
  second.restart(half);
  ASSERT_EQ(second.run(), Structure::finished);
  EXPECT_NEAR(one.inflow(), second.inflow(), 1e-9);
  for (unsigned int l = 0; l < 2; ++l)
    EXPECT_LT(one.tip(l).distance(second.tip(l)), 1e-10);
  std::vector<std::string> names;
  EXPECT_EQ(history(whole, names).size(), history(half, names).size());

  // another scene, and damaged files of the right one
  const auto refusal = [&]() -> std::string {
    ImmersedFlow third(parameters, "", log);
    try
      {
        third.restart(half);
      }
    catch (const ExceptionBase &e)
      {
        return e.what();
      }
    return "";
  };
  EXPECT_EQ(refusal(), "");
  parameters.leaflets[0].n_cells = 3;
  EXPECT_NE(refusal().find("leaflets"), std::string::npos);
  parameters.leaflets[0].n_cells = parameters.leaflets[1].n_cells;
  const std::string state        = half + "/checkpoint/state";
  const auto        size         = std::filesystem::file_size(state);
  {
    // one bit in the middle of a number
    std::fstream file(state, std::ios::in | std::ios::out | std::ios::binary);
    file.seekg(size / 2);
    const char c = file.get() ^ 1;
    file.seekp(size / 2);
    file.put(c);
  }
  EXPECT_NE(refusal().find("damaged"), std::string::npos);
  std::filesystem::resize_file(state, size / 2);
  EXPECT_NE(refusal().find("damaged"), std::string::npos);
}


// A leaflet that nothing stops is pushed through the end of its channel: said
// in words, the last state is saved.
TEST(ImmersedValve, LeafletsThatLeaveTheChannelEndTheRun)
{
  const std::string folder     = "output-immersed-lost";
  Parameters        parameters = closing_valve(folder);
  parameters.leaflets = {{Point<2>(3.6, 0.), Point<2>(3.9, 0.5), 8, false}};
  parameters.material.youngs_modulus = 1e3;
  parameters.inflow                  = "200";
  Structure::Log log(MPI_COMM_SELF, true);
  ImmersedFlow   lost(parameters, "", log);
  EXPECT_EQ(lost.run(), Structure::no_convergence);
  std::ifstream     file(folder + "/run.log");
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_NE(text.str().find("leaves the channel"), std::string::npos);
  ImmersedFlow again(parameters, "", log);
  again.restart(folder);
  EXPECT_EQ(again.time, lost.time);
  EXPECT_GT(again.time, 0.);
}


TEST(ImmersedValve, WrongScenesAreRefusedInWords)
{
  const auto message = [](const std::string &section,
                          const std::string &entry,
                          const std::string &value) -> std::string {
    ParameterHandler prm;
    Parameters::declare(prm);
    Parameters parameters;
    try
      {
        prm.enter_subsection(section);
        prm.set(entry, value);
        prm.leave_subsection();
        parameters.read(prm);
        Structure::Log log(MPI_COMM_SELF, true);
        ImmersedFlow   flow(parameters, "", log);
      }
    catch (const ExceptionBase &e)
      {
        return e.what();
      }
    return "";
  };
  EXPECT_EQ(message("Channel", "Height", "1.61"), "");
  const auto says = [&](const std::string &text, const std::string &words) {
    EXPECT_NE(text.find(words), std::string::npos) << text;
  };
  says(message("Leaflets", "Tips", "2, 0.7"), "'Leaflets/Tips' has 1");
  says(message("Leaflets", "Tips", "2, 0.7; 2"), "expected points");
  says(message("Leaflets", "Tips", "2, 0.7; 9, 0.9"), "of the channel");
  says(message("Leaflets", "Tips", "2, 0.7; 2, 1.61"), "no length");
  says(message("Fluid", "Inflow value", "5*(y"), "expected a formula");
  says(message("Steps", "Smallest step", "1"), "no more than");
  says(message("Contact", "Stiffness scale", "-1"), "does not match");
  says(message("Leaflets", "Roots", ""), "is empty");
}
