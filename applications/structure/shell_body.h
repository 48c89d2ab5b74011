// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_shell_body_h
#define mortar_contact_structure_shell_body_h

#include "mesh_body.h"
#include "shell_directors.h"
#include "shell_element.h"

#include <deal.II/hp/mapping_collection.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace Structure
{
  /// Settings of a shell besides its mesh.
  struct ShellParameters
  {
    ShellSection section;
    /// By material id, where it is not that of the section [m].
    std::map<types::material_id, double> thicknesses;
    /// s of ShellElement [m]; 0: the mean diameter of the cells.
    double director_scale  = 0.;
    bool   is_turned       = false; ///< Top and bottom exchanged.
    double contact_modulus = 0.;    ///< [Pa]
  };

  /**
   * A shell: a mesh of quadrilaterals and triangles in space with the elements
   * of ShellElement. Boundary ids are those of edges. Loads: traction on edges
   * (force per undeformed length; moments too) or on the surface (per
   * undeformed area); pressure on the surface, positive pushes on the top.
   */
  class ShellBody : public MeshBody<2, 3>
  {
  public:
    /// @param mesh The same on all ranks.
    ShellBody(const std::string                &name,
              const Triangulation<2, 3>        &mesh,
              const ShellParameters            &parameters,
              const std::vector<SymmetryPlane> &planes,
              const MPI_Comm                    communicator);

    std::string
    description() const override;

    double
    force_scale(const double size) const override;

    bool
    is_linear() const override
    {
      return false;
    }

    bool
    uses_iterates() const override
    {
      return true;
    }

    bool
    evaluate(const unsigned int    cell,
             const Vector<double> &u,
             const Vector<double> *previous,
             const bool            with_tangent,
             Vector<double>       &forces,
             FullMatrix<double>   &tangent) override;

    bool
    keeps_energy() const override
    {
      return !parameters.section.has_layers();
    }

    void
    evaluate_step(const unsigned int    cell,
                  const Vector<double> &u_n,
                  const Vector<double> &u,
                  const Vector<double> *previous,
                  const bool            with_tangent,
                  Vector<double>       &forces,
                  FullMatrix<double>   &tangent) override;

    void
    commit() override;

    std::vector<double>
    history() const override;

    void
    restore(const std::vector<double> &state) override;

    double
    energy(const unsigned int cell, const Vector<double> &u) override;

    void
    mass(const unsigned int cell, FullMatrix<double> &matrix) override;

    void
    add_load(const unsigned int    cell,
             Load<3>              &load,
             const Vector<double> &u,
             const double          time,
             Vector<double>       &forces,
             FullMatrix<double>   &tangent) override;

    unsigned int
    component_of(const unsigned int dof) const override
    {
      return dof % 6;
    }

    DoFPlace<3>
    place_of(const unsigned int cell, const unsigned int dof) const override;

    void
    visit_boundary_nodes(const std::set<types::boundary_id> &ids,
                         const Visitor &visit) const override;

    void
    visit_nodes(const Visitor &visit) const override;

    void
    add_to(MortarContact::ContactInterface<3> &interface,
           const bool                          secondary,
           const MortarContact::FaceSelection &faces) const override;

    std::vector<MidTriangle>
    mid_surface() const override;

    std::vector<std::array<Point<3>, 3>>
    outer_surface(const Vector<double> &u, const double offset) const override;

    void
    write(const ValuesOfCell &values_of_cell,
          const std::string  &file,
          const MPI_Comm      communicator) override;

  private:
    /// Orientation, directors and thicknesses where this rank has cells.
    void
    set_geometry(const Triangulation<2, 3>        &mesh,
                 const std::vector<SymmetryPlane> &planes);

    /// Node of a cell.
    BoundaryNode<3>
    node_of(const Cell &cell, const unsigned int vertex) const;

    /**
     * A moment m at a point with weights N of a cell's vertices. While the
     * director d turns with the speed d', the material turns with d x d'/d.d
     * about the axes normal to d, so m does the work of a force m x d/d.d on d:
     * what turns about d itself is not felt.
     */
    void
    add_moment(const Cell                &cell,
               const Point<3>            &x,
               const double               weight,
               const std::vector<double> &N,
               Load<3>                   &load,
               const Vector<double>      &u,
               const double               time,
               Vector<double>            &forces,
               FullMatrix<double>        &tangent) const;

    /// Thickness of the skin at a vertex.
    double
    skin_thickness(const unsigned int vertex) const
    {
      return thickness_at.empty() ? parameters.section.thickness :
                                    thickness_at[vertex];
    }

    /// Material and thickness of a cell.
    ShellSection
    section_of(const types::material_id part) const;

    /// Values that history() has of each cell.
    std::size_t
    n_history() const;

    const ShellParameters       parameters;
    hp::MappingCollection<2, 3> mappings;     ///< Of `elements`.
    double                      scale = 0.;   ///< s [m]
    std::vector<int>            orientation;  ///< By active cell.
    std::vector<Tensor<1, 3>>   directors;    ///< By vertex.
    std::vector<double>         thickness_at; ///< Mean of the cells around;
                                              ///< empty: the same everywhere.
    std::vector<ShellElement> shells;         ///< By local cell.
  };
} // namespace Structure

#endif
