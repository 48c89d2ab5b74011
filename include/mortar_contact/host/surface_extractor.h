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
    /// Faces with these ids; empty: with any.
    std::set<types::boundary_id> boundaries;
    /// Of cells with these ids; empty: with any.
    std::set<types::material_id> materials;
    /// Of shells: the facets above and below the cells, and on free edges
    /// (those with the boundary ids above).
    bool top    = true; ///< Of a shell: the side its normal shows to,
    bool bottom = true; ///< the other,
    bool edges  = true; ///< and the free edges.
  };

  /**
   * What a shell shows to contact. The position of a point of its outer
   * surfaces is r +- (thickness/2) d, r = R + v the middle surface and
   * d = D + q/s the director; v and q are components of the shell's finite
   * element, which is linear.
   */
  template <int dim>
  struct ShellSkin
  {
    double       thickness                = 0.; ///< Between top and bottom [m],
    double       director_scale           = 1.; ///< s [m]
    double       modulus                  = 0.; ///< Contact modulus [Pa].
    unsigned int first_component          = 0;  ///< v
    unsigned int first_director_component = dim; ///< q
    /// or by vertex where it varies; else null.
    std::function<double(const unsigned int)> thickness_at;
    /// D at a vertex, by its number in the triangulation; out of the top.
    std::function<Tensor<1, dim>(const unsigned int)> director;
    /// By active cell: +1 if the top is where the cell's own normal points
    /// (x_,r x x_,s; in 2d x_,r turned to the left), else -1.
    std::function<int(const unsigned int)> orientation;
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

  /**
   * Facets of a shell's outer surfaces: top, bottom, and flat facets as wide as
   * the shell is thick on its free edges. Vertices are affine functions of v
   * and q, so that contact forces bend the shell without more ado.
   *
   * The characteristic length is the thickness (as LS-DYNA).
   */
  template <int dim>
  std::vector<SurfaceFacet<dim>>
  extract_shell(const DoFHandler<dim - 1, dim> &dof_handler,
                const FaceSelection            &selection,
                const ShellSkin<dim>           &skin,
                const std::string              &part,
                const DoFNumbering             &numbering);
} // namespace MortarContact

#endif
