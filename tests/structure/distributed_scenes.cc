// SPDX-License-Identifier: LGPL-2.1-or-later

// Scenes whose meshes are dealt to the ranks, or whole on each, against the
// same scenes on one rank: displacements of all nodes, forces, facets in
// contact, and what the material remembers.

#include "../support/rings.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <vector>

using namespace Test;

namespace
{
  struct Result
  {
    std::vector<double>       displacements, history, forces;
    std::vector<unsigned int> n_cells; ///< By body.
    /// Centres of facets in contact, ascending.
    std::vector<std::array<double, 3>> in_contact;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &displacements &history &forces &n_cells &in_contact;
    }
  };


  template <int dim>
  Result
  result_of(const Simulation<dim> &s)
  {
    Result               result;
    const Vector<double> u(s.u);
    for (const auto &body : s.model.bodies)
      {
        result.n_cells.push_back(body->n_cells());
        for (const auto dof : body->dofs_in_order())
          result.displacements.push_back(u(dof));
        const auto history = body->history();
        result.history.insert(result.history.end(),
                              history.begin(),
                              history.end());
      }
    for (const auto &interface : s.model.interfaces)
      {
        for (unsigned int i = 0; i < dim; ++i)
          result.forces.push_back(interface->report().force[i]);
        result.forces.push_back(interface->report().active_area);
        for (const auto &state :
             MortarContact::facet_states(*interface, s.model.communicator))
          if (state.penetration > 0.)
            {
              // round-off of a mean must not change the order
              Point<dim> centre;
              for (unsigned int v = 0; v < state.reference.n_vertices; ++v)
                centre += state.reference.x[v];
              std::array<double, 3> rounded = {};
              for (unsigned int i = 0; i < dim; ++i)
                rounded[i] = std::round(1e6 * centre[i]);
              result.in_contact.push_back(rounded);
            }
      }
    std::sort(result.in_contact.begin(), result.in_contact.end());
    return result;
  }


  /// The largest difference over the largest value.
  double
  difference(const std::vector<double> &a, const std::vector<double> &b)
  {
    if (a.size() != b.size())
      return 1.;
    double difference = 0., largest = 1e-300;
    for (std::size_t i = 0; i < a.size(); ++i)
      {
        difference = std::max(difference, std::abs(a[i] - b[i]));
        largest    = std::max(largest, std::abs(b[i]));
      }
    return difference / largest;
  }


  template <int dim>
  Result
  expect_the_same_on_one_rank(const std::string &text,
                              const bool         is_whole = false)
  {
    const unsigned int n_ranks =
      Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
    Result alone;
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      try
        {
          Log  log(MPI_COMM_SELF, true);
          auto s = make<dim>(text, log, MPI_COMM_SELF);
          EXPECT_EQ(s->run(), finished);
          alone = result_of(*s);
        }
      catch (const std::exception &e)
        {
          ADD_FAILURE() << e.what(); // the others wait for the result
        }
    alone               = Utilities::MPI::broadcast(MPI_COMM_WORLD, alone);
    const auto   s      = run<dim>(text);
    const Result result = result_of(*s);
    EXPECT_LT(difference(result.displacements, alone.displacements), 1e-10);
    EXPECT_LT(difference(result.forces, alone.forces), 1e-10);
    EXPECT_LT(difference(result.history, alone.history), 1e-10);
    EXPECT_EQ(result.n_cells, alone.n_cells);
    EXPECT_FALSE(alone.in_contact.empty());
    EXPECT_EQ(result.in_contact, alone.in_contact);

    for (const auto &body : s->model.bodies)
      {
        EXPECT_EQ(body->is_whole(), is_whole || n_ranks == 1);
        const auto         *solid = dynamic_cast<MeshBody<dim, dim> *>(&*body);
        const auto         *shell = dynamic_cast<MeshBody<2, 3> *>(&*body);
        const unsigned long known =
          Utilities::MPI::sum(shell ? shell->triangulation.n_active_cells() :
                                      solid->triangulation.n_active_cells(),
                              MPI_COMM_WORLD);
        if (n_ranks >= 4 && !is_whole)
          {
            EXPECT_LT(known, 0.8 * n_ranks * body->n_cells());
          }
      }
    return alone;
  }


  const std::string rubber = "Law = neo-Hookean|Young's modulus = 2|"
                             "Poisson's ratio = ";
} // namespace


TEST(DistributedScenes, CurvedHexahedraWithFriction)
{
  expect_the_same_on_one_rank<3>(
    rings("Inner radius = 0.5|Outer radius = 1|Length = 0.4|Cells = 8, 2, 2",
          rubber + "0.3",
          "Inner radius = 1|Outer radius = 1.5|Length = 0.4|Cells = 10, 2, 2",
          rubber + "0.4",
          ", floor i, floor o, press, turn",
          "Degree = 2") +
    condition("floor i", "Body = inner|Boundary ids = 4|Type = symmetry") +
    condition("floor o", "Body = outer|Boundary ids = 4|Type = symmetry") +
    condition("press",
              "Body = outer|Boundary ids = 3|Type = pressure|"
              "Pressure = 0.05*t*(1 + 0.3*x)") +
    condition("turn", "Body = inner|Boundary ids = 2|z = 0.02*t") +
    interface("fit",
              "Stiffness scale = 10|Friction coefficient = 0.3|"
              "Initial penetration = ignore") +
    probe("in", "inner", "1, 0, 0") + probe("out", "outer", "1, 0, 0") +
    solver(1e-12, 0.5));
}


TEST(DistributedScenes, TetrahedraOnNearlyIncompressibleHexahedra)
{
  // conditions by formula and at a point; vertices moved by a map
  expect_the_same_on_one_rank<3>(
    names("lower, upper", "floor, sides, top, point", "i") +
    body("lower",
         "Upper corner = 2,1,0.5|Cells = 10,5,2|"
         "Map = x; y; z + 0.02*sin(5*x)*z",
         rubber + "0.499") +
    body("upper",
         "Lower corner = 0.2,0.2,0.5|Upper corner = 1.6,0.8,1|Cells = 7,3,2|"
         "Simplices = true|Move = 0,0,0.02",
         rubber + "0.3") +
    condition("floor", "Body = lower|Boundary ids = 4|x = 0|y = 0|z = 0") +
    condition("sides", "Body = upper|Where = if(z > 1 && x < 1, 1, 0)|y = 0") +
    condition("top", "Body = upper|Boundary ids = 5|z = -0.1*t") +
    condition("point", "Body = upper|Point = 1, 0.5, 1.1|x = 0") +
    interface(
      "i",
      "Stiffness scale = 10|Secondary = upper: boundary 4|Primary = lower: boundary 5") +
    solver(1e-12, 0.5));
}


TEST(DistributedScenes, PlasticShells)
{
  // quadrilaterals and triangles in one shell; three sheets at one edge
  const Result result = expect_the_same_on_one_rank<3>(
    names("strip, cover, sheets", "clamp, hold, end, pull", "i") +
    body("strip",
         "Type = file|File = " MORTAR_CONTACT_SOURCE_DIR
         "/prm/verification/shell_mixed.inp|Boundary id formula = if(x < 1e-6, "
         "0, if(x > 10 - 1e-6, 1, 2))",
         "Young's modulus = 1.2e6|Poisson's ratio = 0.3|Yield stress = 200|"
         "Hardening modulus = 1e5",
         "Type = shell|Thickness = 0.1") +
    body("cover",
         "Lower corner = 4,-0.2|Upper corner = 11,1.2|Cells = 12,3|"
         "Map = x; y; 0.1 + 0.001*x|Simplices = true",
         "Young's modulus = 1.2e6|Poisson's ratio = 0.3",
         "Type = shell|Thickness = 0.1") +
    body("sheets",
         "Type = file|File = " MORTAR_CONTACT_SOURCE_DIR
         "/prm/verification/shell_junction.inp|Boundary id formula = "
         "if(abs(x) > 0.399, 1, if(z > 0.25, 2, -1))",
         "Young's modulus = 1e7|Poisson's ratio = 0.3|Yield stress = 300|"
         "Hardening modulus = 1e6",
         "Type = shell|Thickness = 0.01") +
    condition("clamp",
              "Body = strip|Boundary ids = 0|x = 0|y = 0|z = 0|"
              "Directors = fixed") +
    condition("hold",
              "Body = cover|Boundary ids = 1|x = 0|y = 0|z = -0.1*t|"
              "Directors = fixed") +
    condition("end",
              "Body = sheets|Boundary ids = 1|x = 0|y = 0|z = 0|"
              "Directors = fixed") +
    condition("pull",
              "Body = sheets|Boundary ids = 2|Type = traction|z = 0.05*t") +
    interface("i", "Secondary = cover|Primary = strip") + solver(1e-12, 0.25));
  EXPECT_GT(*std::max_element(result.history.begin(), result.history.end()),
            0.);
}


TEST(DistributedScenes, TrianglesInThePlane)
{
  expect_the_same_on_one_rank<2>(
    rings("Inner radius = 0.2|Outer radius = 0.61|Cells = 24, 4|"
          "Simplices = true",
          linear_steel("1e9", "0.2"),
          "Inner radius = 0.6|Outer radius = 1|Cells = 30, 4|Simplices = true",
          linear_steel("1e9", "0.2"),
          ", load") +
    cosine_load() + interface("fit", "Stiffness scale = 20") +
    probe("in", "inner", "0.6, 0") + probe("out", "outer", "0.6, 0") +
    solver(1e-12));
}


TEST(DistributedScenes, RefinedBlockOnOneCell)
{
  const Result result = expect_the_same_on_one_rank<3>(
    names("lower, upper", "floor, top", "i") +
      body("lower", "Upper corner = 1,1,0.5|Cells = 1,1,1", rubber + "0.3") +
      body("upper",
           "Lower corner = 0.2,0.3,0.5|Upper corner = 0.7,0.9,1|Cells = 3,3,2",
           rubber + "0.3") +
      condition("floor", "Body = lower|Boundary ids = 4|x = 0|y = 0|z = 0") +
      condition("top",
                "Body = upper|Boundary ids = 5|x = 0|y = 0|z = -0.05*t") +
      interface("i",
                "Characteristic length = 0.2|Stiffness scale = 10|"
                "Secondary = upper: boundary 4|Primary = lower: boundary 5") +
      section("Refinement", "Every = 1|Most levels = 1|Refine = 0.4") +
      solver(1e-12, 0.5),
    /* is_whole = */ true);
  EXPECT_GT(result.n_cells[0] + result.n_cells[1], 1 + 3 * 3 * 2);
}
