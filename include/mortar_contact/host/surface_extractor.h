// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_host_surface_extractor_h
#define mortar_contact_host_surface_extractor_h

#include <mortar_contact/host/contact_surface.h>
#include <mortar_contact/host/dof_numbering.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/mapping.h>

#include <functional>
#include <set>
#include <string>

namespace MortarContact
{
  /// Which boundary faces belong to a surface. An empty set means all.
  struct FaceSelection
  {
    std::set<types::boundary_id> boundaries;
    std::set<types::material_id> materials;
  };

  /// Faces with one of these boundary ids.
  inline FaceSelection
  boundary_ids(const std::set<types::boundary_id> &ids)
  {
    return {ids, {}};
  }

  /// All boundary faces of cells with one of these material ids.
  inline FaceSelection
  material_ids(const std::set<types::material_id> &ids)
  {
    return {{}, ids};
  }

  /// Contact modulus [Pa] of a cell, see bulk_contact_modulus().
  template <int dim>
  using ModulusOfCell = std::function<double(
    const typename DoFHandler<dim>::active_cell_iterator &)>;

  /**
   * Facets of the selected boundary faces of the locally owned cells.
   *
   * Faces of degree one are facets. Faces of degree two become four linear
   * sub-facets (two in 2d), whose vertices between the corners are
   *   x_mid = 4/3 x_node - 1/6 (x_end + x_end'):
   * then the skin encloses the volume that the quadratic face encloses, and a
   * uniform pressure on the skin gives the consistent nodal forces of the
   * quadratic face, so that the patch test is passed. Hanging nodes need
   * nothing: host constraints apply to the dofs.
   *
   * Normals are made to point out of the cell. The element's displacement
   * components are those from @p first_component on.
   *
   * @throw ExcMessage if faces have a degree above two, or two cells of the
   * body behind a face are inside out.
   */
  template <int dim>
  std::vector<SurfaceFacet<dim>>
  extract_surface(const DoFHandler<dim>    &dof_handler,
                  const Mapping<dim>       &mapping,
                  const FaceSelection      &selection,
                  const ModulusOfCell<dim> &modulus_of_cell,
                  const std::string        &part,
                  const DoFNumbering       &numbering,
                  const unsigned int        first_component,
                  const MPI_Comm            communicator);
} // namespace MortarContact

#endif
