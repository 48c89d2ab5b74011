// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_search_pair_filter_h
#define mortar_contact_search_pair_filter_h

#include <mortar_contact/geometry/skin.h>

#include <vector>

namespace MortarContact
{
  /**
   * Says which pairs of facets can be in contact at all.
   *
   * Self-contact (both skins the same object): two facets of the same part are
   * no pair if they are neighbours in the undeformed body, that is, if neither
   * lies in front of the other there and they are closer than
   *   max(2 reach, 1.5 depth),
   * depth the distance of one behind the other (up to three times the reach).
   * So a wall does not see its own far side however thin it is, and faces that
   * look at each other across a slot are a pair however narrow it is. No
   * counting of elements: the rule does not depend on the mesh.
   */
  template <int dim>
  class PairFilter
  {
  public:
    /// Facets may turn a little before the next search: pairs up to this far
    /// (as a cosine) beyond the limit stay candidates.
    static constexpr double turning = 0.35;

    /// @param zero_cosine, ceiling As in KernelOptions.
    PairFilter(const Skin<dim> &secondary,
               const Skin<dim> &primary,
               const double     zero_cosine,
               const double     ceiling)
      : secondary(secondary)
      , primary(primary)
      , limit(zero_cosine - turning)
      , ceiling(ceiling)
      , is_self(&secondary == &primary)
    {
      for (const auto &f : secondary.facets)
        normals_s.push_back(unit_normal(f.current));
      if (is_self)
        normals_p = normals_s;
      else
        for (const auto &f : primary.facets)
          normals_p.push_back(unit_normal(f.current));
    }

    /// Whether the facets face each other, nearly, and share no vertex.
    bool
    may_touch(const unsigned int s, const unsigned int p) const
    {
      return -(normals_s[s] * normals_p[p]) > limit && !are_neighbours(s, p);
    }

    /// Whether the facets face each other now: pairs that do not carry no
    /// force, whatever their distance.
    bool
    face_each_other(const unsigned int s, const unsigned int p) const
    {
      return -(normals_s[s] * normals_p[p]) > limit + turning &&
             !are_neighbours(s, p);
    }

    /// Whether the facets are no pair wherever they are: they share a vertex,
    /// are neighbours in the undeformed body, or both rigid.
    bool
    are_neighbours(const unsigned int s, const unsigned int p) const
    {
      if (share_vertex(secondary, s, primary, p))
        return true;
      const ContactFacet<dim> &fs = secondary.facets[s];
      const ContactFacet<dim> &fp = primary.facets[p];
      if (fs.compliance[0] == 0. && fp.compliance[0] == 0.)
        return true; // rigid against rigid
      if (!is_self || secondary.parts[s] != primary.parts[p])
        return false;
      const Tensor<1, dim> r = centre(fp.reference) - centre(fs.reference);
      const double         front_s = unit_normal(fs.reference) * r;
      const double         front_p = -(unit_normal(fp.reference) * r);
      const double sizes = diameter(fs.reference) + diameter(fp.reference);
      if (std::max(front_s, front_p) > flat * sizes)
        return false;
      const double reach = ceiling * std::max(fs.length[0], fp.length[0]);
      const double depth = -std::min(front_s, front_p);
      // what is thicker cannot be squeezed into reach, but may bend onto itself
      if (depth > 3. * reach)
        return false;
      return r.norm() - 0.5 * sizes < std::max(2. * reach, 1.5 * depth);
    }

    /// Whether two facets of one surface have a vertex in common.
    static bool
    share_vertex(const Skin<dim>   &secondary,
                 const unsigned int s,
                 const Skin<dim>   &primary,
                 const unsigned int p)
    {
      for (unsigned int a = 0; a < secondary.facets[s].current.n_vertices; ++a)
        for (unsigned int b = 0; b < primary.facets[p].current.n_vertices; ++b)
          if (secondary.vertices[s][a] == primary.vertices[p][b])
            return true;
      return false;
    }

  private:
    static Tensor<1, dim>
    unit_normal(const Facet<dim> &facet)
    {
      const Tensor<1, dim> w = centre_normal(facet);
      return w / w.norm();
    }

    /// A centre in front of a facet by less than this share of the diameters
    /// lies in the same surface.
    static constexpr double flat = 0.02;

    const Skin<dim>            &secondary;
    const Skin<dim>            &primary;
    const double                limit, ceiling;
    const bool                  is_self;
    std::vector<Tensor<1, dim>> normals_s, normals_p;
  };
} // namespace MortarContact

#endif
