// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_mid_surfaces_h
#define mortar_contact_structure_mid_surfaces_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <deal.II/lac/vector.h>

#include <array>
#include <vector>

namespace Structure
{
  using namespace dealii;

  /// A triangle of a shell's mid-surface; a quadrilateral is two of them.
  struct MidTriangle
  {
    /// Displacement dofs of its vertices. Vertices are the same where their
    /// first dofs are.
    std::array<std::array<types::global_dof_index, 3>, 3> dofs;
    std::array<Point<3>, 3>                               x; ///< Undeformed.
    double                                                thickness; ///< [m]
    unsigned int part; ///< Parts see each other however near they are.

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &dofs &x &thickness &part;
    }
  };

  /**
   * How near mid-surfaces of shells come to each other, and whether they cross.
   * Contact keeps their outer surfaces apart but for the penetration: so
   * distances below the thickness mean that it is not resolved, and a mesh of
   * what is between the shells cannot be made where they cross.
   *
   * Triangles hang together, and are not compared, if they share a vertex or if
   * they are of one part and nearer than `farthest` thicknesses in the
   * undeformed state.
   */
  class MidSurfaces
  {
  public:
    /// @param triangles The same on all ranks.
    MidSurfaces(const std::vector<MidTriangle> &triangles,
                const MPI_Comm                  communicator);

    /// Distances are looked for up to this many thicknesses.
    static constexpr double farthest = 2.;

    struct State
    {
      /// Smallest distance over the mean thickness of the two [-]; `farthest`:
      /// all are at least so far apart.
      double distance = farthest;
      /// Pairs of triangles that intersect, by exact predicates.
      unsigned int n_crossing = 0;
    };

    /// Collective.
    /// @param u All displacements.
    State
    state(const Vector<double> &u) const;

  private:
    std::vector<MidTriangle> triangles;
    double                   reach = 0.; ///< Of the search [m]
    MPI_Comm                 communicator;
    /// By triangle of this rank: those with a higher number that it hangs
    /// together with, ascending.
    std::vector<std::vector<unsigned int>> joined;
  };
} // namespace Structure

#endif
