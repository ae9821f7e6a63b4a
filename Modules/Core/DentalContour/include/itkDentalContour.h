/*=========================================================================
 *
 *  Copyright The DentalSCR authors
 *
 *  Licensed under the Apache License, Version 2.0 (the "License");
 *  you may not use this file except in compliance with the License.
 *  You may obtain a copy of the License at
 *
 *         https://www.apache.org/licenses/LICENSE-2.0
 *
 *  Unless required by applicable law or agreed to in writing, software
 *  distributed under the License is distributed on an "AS IS" BASIS,
 *  WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
 *  See the License for the specific language governing permissions and
 *  limitations under the License.
 *
 *=========================================================================*/
#ifndef itkDentalContour_h
#define itkDentalContour_h

#include "DentalContourExport.h"
#include "itkToothCode.h"

#include "itkDefaultStaticMeshTraits.h"
#include "itkMesh.h"
#include "itkPoint.h"
#include "itkVector.h"

#include <vector>

namespace itk
{
/** \class DentalContour
 * \brief Contours in a radiograph: a 2-D mesh with line cells, the tooth's FDI number as the points' pixel data.
 *
 * Points are continuous pixel indices (0 = centre of the first pixel, u right, v down). Every segment is a LineCell, so
 * that a gap between two teeth is a gap and not an edge; where only points matter it serves as an itk::PointSet. Used
 * alike for a tracing (fixed contour), for a silhouette (moving contour) and for what a segmentation yields.
 *
 * Polylines are read back from the cells: they are runs of line cells in which each starts where the one before ended;
 * a run that returns to its first point is closed; a point without a cell is a polyline of one point. A contour built
 * with the Mesh interface alone is therefore as good as one built with AddPolyline().
 *
 * A silhouette's points may know more: the point of the surface that projects to them, the outward normal, the tooth.
 * What makes silhouettes from a mesh writes them, what moves, cuts or resamples contours carries them. Files of
 * contours have none of it.
 *
 * \ingroup DentalContour
 */
class DentalContour_EXPORT DentalContour
  : public Mesh<uint8_t, 2, DefaultStaticMeshTraits<uint8_t, 2, 2, double, double, uint8_t>>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(DentalContour);

  using Self = DentalContour;
  using Superclass = Mesh<uint8_t, 2, DefaultStaticMeshTraits<uint8_t, 2, 2, double, double, uint8_t>>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(DentalContour, Mesh);

  using PointType = Superclass::PointType;
  /** Outward unit normal in the image, u right, v down. */
  using NormalType = Vector<double, 2>;
  /** Point of a surface, mm, in the frame of its mesh. */
  using RimPointType = Point<double, 3>;

  /** What of a tooth was drawn. */
  enum class OutlineEnum : uint8_t
  {
    /** Nobody said it. */
    Unspecified,
    Crown,
    /** Crown and root. */
    Tooth,
    /** The labial side alone. */
    Labial
  };

  /** One stretch of contour. A closed one does not repeat its first point. */
  struct PolylineType
  {
    ToothCode              code;            /**< The tooth whose border it is; unknown: the contour of a jaw. */
    bool                   closed{ false }; /**< Whether the last point is joined to the first. */
    std::vector<PointType> points;          /**< Continuous pixel indices, in order. */
    /** Weights of the points, 1 = full, 0 = ignored (uncertain tracing); empty means all 1. */
    std::vector<double> weights;
    /** Drawing errors of the points, standard deviations an axis in pixels, 0 where nobody said one; empty means all
     * 0. */
    std::vector<double> sigmas{};
    OutlineEnum         outline{ OutlineEnum::Unspecified };
    /** A registration projected it and no hand has moved any of its points since: of that registration, and of a later
     * one of the same scan, it is no independent evidence. */
    bool drafted{ false };
    /** Of a silhouette: outward unit normals in the image (u right, v down), one a point, (0, 0) where it is not known;
     * empty where none is. */
    std::vector<NormalType> normals{};
    /** Of a silhouette: the points of the surface that project to its points, mm, in the frame of the mesh that the
     * silhouette was made of; one a point, NaN where it is not known; empty where none is. */
    std::vector<RimPointType> rimPoints{};
    /** The teeth of the points where they are not all of one, and then `code` is that of the first; one a point or
     * empty. */
    std::vector<ToothCode> teeth{};

    /** Tooth of a point. */
    ToothCode
    GetTooth(std::size_t index) const
    {
      return teeth.empty() ? code : teeth[index];
    }
  };

  using PolylinesType = std::vector<PolylineType>;

  /** Appends a polyline. Throws where a point is not finite, where weights are given but are not one a point in [0, 1],
   * where sigmas are given but are not one a point and finite, where normals (units or 0), rim points (finite or NaN
   * as a whole) or teeth are given but are not one a point, or where a closed polyline has fewer than 3 points. An
   * empty polyline adds nothing. */
  void
  AddPolyline(const PolylineType & polyline);
  void
  AddPolyline(const std::vector<PointType> & points, ToothCode code = ToothCode(), bool closed = false);

  /** The polylines in the order of their cells, then the lone points. */
  PolylinesType
  GetPolylines() const;

  /** Sum of the segments' lengths, pixels. */
  double
  GetLength() const;

  /** Code of a point; unknown where the point has no data. */
  ToothCode
  GetToothCode(PointIdentifier id) const;

  /** Weight of a point; 1 where none was given. */
  double
  GetPointWeight(PointIdentifier id) const;

  /** Drawing error of a point, pixels; 0 where none was given. */
  double
  GetPointSigma(PointIdentifier id) const;

  /** What of its tooth the polyline of a point shows. */
  OutlineEnum
  GetPointOutline(PointIdentifier id) const;

  /** Whether the polyline of a point is a registration's own, unmended. */
  bool
  IsPointDrafted(PointIdentifier id) const;

  /** Share of the points with a weight above 0 that are of drafted polylines, 0 to 1; 0 where there are no points. */
  double
  GetDraftedShare() const;

  /** Outward normal at a point; (0, 0) where it is not known. */
  NormalType
  GetPointNormal(PointIdentifier id) const;

  /** Whether it is known of any point which point of a surface projects to it. */
  bool
  HasRimPoints() const
  {
    return !m_RimPoints.empty();
  }
  /** Point of the surface that projects to a point; NaN where it is not known. */
  RimPointType
  GetRimPoint(PointIdentifier id) const;

  /** "crown", "tooth" or "labial", as in a tracing's file. Throws std::invalid_argument otherwise. */
  static OutlineEnum
  OutlineFromString(const std::string & text);
  /** Takes all points, lines and codes out. */
  void
  Initialize() override;

  void
  Graft(const DataObject * data) override;

protected:
  DentalContour() = default;
  ~DentalContour() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  std::vector<double>       m_PointWeights;
  std::vector<double>       m_PointSigmas;
  std::vector<OutlineEnum>  m_PointOutlines;
  std::vector<bool>         m_PointsDrafted;
  std::vector<NormalType>   m_PointNormals;
  std::vector<RimPointType> m_RimPoints;
};

/** Appends the point `index` of `from` to `to` with all that is known of it: weight, drawing error, normal, rim point
 * and tooth. What one of the two does not say is filled as if it had said it. The first point gives `to` its code and
 * its outline, and one of another outline takes that away. For filters that cut, join or resample polylines: none of
 * them knows which fields there are. \ingroup DentalContour */
DentalContour_EXPORT void
AppendPoint(const DentalContour::PolylineType & from, std::size_t index, DentalContour::PolylineType & to);

/** The runs of points of a polyline that are kept, open; or all of it as it is. A closed one is walked from a point
 * that is dropped, so that no run is cut where the polyline begins. \ingroup DentalContour */
DentalContour_EXPORT DentalContour::PolylinesType
                     KeepPoints(const DentalContour::PolylineType & polyline, const std::vector<bool> & keep);

/** "crown", "tooth", "labial", or "unspecified". \ingroup DentalContour */
DentalContour_EXPORT std::ostream &
                     operator<<(std::ostream & os, DentalContour::OutlineEnum outline);
} // namespace itk

#endif
