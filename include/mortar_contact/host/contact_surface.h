// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_host_contact_surface_h
#define mortar_contact_host_contact_surface_h

#include <mortar_contact/geometry/skin.h>
#include <mortar_contact/host/rigid_body.h>
#include <mortar_contact/report/contact_report.h>

#include <deal.II/base/types.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace MortarContact
{
  /**
   * One row of the vertex map: the position of a vertex is
   *   x = X + sum_k w_k u(dofs_k),
   * dofs_k the global numbers of the dim displacement components of a node.
   * The first entry is the node that the vertex belongs to. Vertices of rigid
   * bodies have no entries.
   */
  template <int dim>
  struct SurfaceVertex
  {
    /// One node's part of the position.
    struct Entry
    {
      std::array<types::global_dof_index, dim> dofs;   ///< Of the node.
      double                                   weight; ///< w [-]

      /// For checkpoints and between ranks.
      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &dofs &weight;
      }
    };

    Tensor<1, dim>     reference; ///< X [m]
    std::vector<Entry> row;       ///< Of the vertex map.

    /// Rigid body of the surface, see ContactSurface::rigid_bodies; for
    /// vertices without entries.
    unsigned int rigid_body   = 0;
    unsigned int rigid_vertex = 0; ///< Vertex of that body.

    /// The same for the same vertex on all cells and ranks. Rigid vertices
    /// count from above.
    types::global_dof_index
    key() const
    {
      return row.empty() ? numbers::invalid_dof_index - 1 - rigid_vertex :
                           row.front().dofs[0];
    }

    /// For checkpoints and between ranks.
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &reference &row &rigid_body &rigid_vertex;
    }
  };

  /// A facet of a surface as it is extracted.
  template <int dim>
  struct SurfaceFacet
  {
    unsigned int n_vertices = 0; ///< 2 (2d), 3 or 4.
    /// The first n_vertices count.
    std::array<SurfaceVertex<dim>, max_vertices<dim>> vertices;
    FacetLabel                                        label; ///< For reports.
    unsigned int face     = 0;  ///< Face of the cell, and
    unsigned int subfacet = 0;  ///< part of the face.
    double       modulus  = 0.; ///< K of the cell's material [Pa]; 0: rigid
    double       length   = 0.; ///< Height of the cell over the face [m]
    double       shortest_edge = 0.; ///< Of the part [m]

    /// Between ranks.
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &n_vertices &vertices &label &face &subfacet &modulus &length
        &shortest_edge;
    }
  };

  /// A facet of a built surface as another rank gets to know it.
  template <int dim>
  struct NearFacet
  {
    SurfaceFacet<dim> facet;      ///< With modulus and length as used.
    Facet<dim>        current;    ///< See ContactFacet.
    VertexValues<dim> compliance; ///< See ContactFacet.
    VertexValues<dim> length;     ///< See ContactFacet.
    unsigned int      number;     ///< On the rank it belongs to.
    /// Of the dofs of the rows, in their order; several states one after the
    /// other.
    std::vector<double> values;
    /// The facet at the end of the last accepted step; empty: no friction.
    std::vector<Facet<dim>> before;

    /// Between ranks.
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &facet &current &compliance &length &number &values &before;
    }
  };

  /// How the contact stiffness of a surface is chosen.
  struct SurfaceStiffness
  {
    double modulus           = 0.;    ///< [Pa]; 0: of the cells.
    double length            = 0.;    ///< [m]; 0: of the cells.
    bool   use_shortest_edge = false; ///< For length: of the part.
    double offset            = 0.;    ///< Contact surface over mesh [m]
  };

  /**
   * A contact surface as one rank knows it: its own facets and those of other
   * ranks that have come near, their vertex map, and the skin in the present
   * configuration.
   */
  template <int dim>
  class ContactSurface
  {
  public:
    /// Take the facets of this rank; collective. Moduli and lengths are
    /// averaged at the vertices over the facets of all ranks, weighted by area,
    /// so that the contact stiffness is continuous.
    void
    build(std::vector<SurfaceFacet<dim>> facets,
          const SurfaceStiffness        &stiffness,
          const MPI_Comm                 communicator);

    /// Facet @p f of this rank for another; without values and `before`.
    NearFacet<dim>
    describe(const unsigned int f) const;

    /// Add a facet of another rank.
    void
    add(const NearFacet<dim> &near, const unsigned int rank);

    /// Rank that a facet belongs to, and its number there.
    std::pair<unsigned int, unsigned int>
    origin(const unsigned int f) const;

    /// Move the skin; @p displacement gives the value of a dof.
    void
    move(const std::function<double(types::global_dof_index)> &displacement);

    /// Where the facets would be with other displacements.
    std::vector<Facet<dim>>
    moved(
      const std::function<double(types::global_dof_index)> &displacement) const;

    /// Dofs of all rows that this rank knows, sorted, without repetition.
    std::vector<types::global_dof_index>
    dofs() const;

    /// Vertex @p a of a facet.
    const SurfaceVertex<dim> &
    vertex(const unsigned int facet, const unsigned int a) const
    {
      return vertices[facet_vertices[facet][a]];
    }

    Skin<dim>               skin;   ///< In the present configuration.
    std::vector<FacetLabel> labels; ///< By facet.
    /// Face of the cell and part of the face, by facet.
    std::vector<std::pair<unsigned int, unsigned int>> faces;
    /// Parts of all ranks, in the order of their numbers in the skin.
    std::vector<std::string> parts;
    std::vector<double>      cell_modulus; ///< By facet [Pa]; zero where rigid.
    std::vector<double>      cell_length;  ///< By facet [m]; zero where rigid.

    /// Whose facets have no dofs.
    std::vector<std::shared_ptr<RigidBody<dim>>> rigid_bodies;

  private:
    /// Append a facet: its vertices, and what is known by facet.
    void
    append(const SurfaceFacet<dim> &facet,
           const double             modulus,
           const double             length);

    Tensor<1, dim>
    position(
      const SurfaceVertex<dim>                             &v,
      const std::function<double(types::global_dof_index)> &displacement) const;

    std::vector<SurfaceVertex<dim>>                          vertices;
    std::vector<std::array<unsigned int, max_vertices<dim>>> facet_vertices;
    std::map<types::global_dof_index, unsigned int> numbers;     ///< By key.
    double                                          offset = 0.; ///< [m]
    unsigned int                                    rank   = 0;
    /// See origin(), from the first facet of another rank on.
    std::vector<std::pair<unsigned int, unsigned int>> origins;
  };

  /// Add up over all ranks what each has at its vertices, by their key: all get
  /// the sums at their own vertices. The arrays must be of one size.
  void
  sum_at_vertices(
    std::map<types::global_dof_index, std::vector<double>> &at_vertices,
    const MPI_Comm                                          communicator);
} // namespace MortarContact

#endif
