// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_host_contact_output_h
#define mortar_contact_host_contact_output_h

#include <mortar_contact/host/contact_interface.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace MortarContact
{
  /// State of one facet of a contact surface, for pictures and checks.
  template <int dim>
  struct FacetState
  {
    /// Deformed [m].
    Facet<dim> current;
    /// Undeformed [m].
    Facet<dim> reference;
    /// Contact pressure at the vertices, Cauchy: contact force per present
    /// area, positive; zero without contact [Pa].
    VertexValues<dim> pressure = {};
    /// Tangential traction at the vertices, by friction and ties [Pa].
    VertexValues<dim> shear = {};

    /// What happens on the facet.
    enum class Status
    {
      open,
      stick, ///< Or in contact without friction.
      slip,  ///< Some of it.
      tied
    };
    /// Of most of its points.
    Status       status      = Status::open;
    double       penetration = 0.; ///< Deepest on the facet [m]
    double       relative    = 0.; ///< Over the release depth [-]
    unsigned int side        = 0;  ///< 0 secondary, 1 primary.
    double       modulus     = 0.; ///< Of the cell [Pa]; 0: rigid.
    /// Part and cell behind the facet.
    FacetLabel label;
    /// Face of the cell, and part of the face.
    std::pair<unsigned int, unsigned int> face;
    /// Numbers of its vertices: those of neighbours are the same.
    std::array<unsigned int, max_vertices<dim>> vertices = {};

    /// Between ranks.
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &current &reference &pressure &shear &status &penetration
        &relative &side &modulus &label &face &vertices;
    }
  };

  /**
   * State of this rank's facets of both sides after ContactInterface::update().
   * Collective.
   *
   * The pressure at a vertex is the contact force on it along the normals of
   * its facets over the share of area of it: sum_f F_fa / sum_f A_f / n_f (A_f
   * area, n_f vertices of facet f): exact for uniform pressure on
   * parallelograms and triangles that contact covers.
   */
  template <int dim>
  std::vector<FacetState<dim>>
  own_facet_states(const ContactInterface<dim> &contact,
                   const MPI_Comm               communicator);

  /// The same of all facets, on all ranks, in an order that does not depend on
  /// their number: for checks, and surfaces that fit into memory.
  template <int dim>
  std::vector<FacetState<dim>>
  facet_states(const ContactInterface<dim> &contact,
               const MPI_Comm               communicator);

  /// Write the contact surfaces of an interface as a VTU file, on rank 0.
  template <int dim>
  void
  write_contact_vtu(const ContactInterface<dim> &contact,
                    const std::string           &file,
                    const MPI_Comm               communicator);
} // namespace MortarContact

#endif
