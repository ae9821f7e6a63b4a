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
#include "itkCrownDraftSource.h"

#include "itkDentalCaseFileReader.h"
#include "itkMakeTriangleSurface.h"
#include "itkOpenSilhouette.h"
#include "itkScanCheckFilter.h"
#include "itkToothCrownFilter.h"
#include "itkUMidlineDentalAxisFilter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <unordered_map>
#include <vector>

namespace itk
{
namespace
{
using JawEnum = ToothCode::JawEnum;
using MeshType = DentalCaseData::MeshType;
using PointType = std::array<double, 3>;

/** mm a unit of the picture in which facing is judged, as in the registration (PoseWorkingPixel). */
constexpr double Unit = 0.25;
/** mm beyond the midline that a side keeps, so that its central incisor is whole where the plane is off. */
constexpr double MidlineMargin = 0.5;
/** mm to the crown's nearest point, beyond which a point of the outline is gingiva. A crown that was cut out by a
 * textbook's width leaves gaps of this size between teeth. */
constexpr double Reach = 1.0;
/** mm: a shorter piece of a tooth shows nothing that could be drawn. */
constexpr double ShortestDraft = 1.5;
/** mm between points of a draft: a hand that mends one moves a few points, not fifty. */
constexpr double PointSpacing = 1.0;

double
SquaredDistance(const PointType & a, const PointType & b)
{
  double sum = 0.0;
  for (unsigned int d = 0; d < 3; ++d)
  {
    sum += (a[d] - b[d]) * (a[d] - b[d]);
  }
  return sum;
}

} // namespace

/** What a source holds: named, as its class is known outside of this file. */
namespace CrownDraftParts
{
/** Tells to which crown a point of the scan belongs: the crowns' points in cells as wide as the reach. */
class ToothIndex
{
public:
  void
  Add(const ToothCrownSet::CrownType & crown)
  {
    const auto      tooth = static_cast<std::uint32_t>(m_Centres.size());
    const PointType centre = crown.surface->AreaCentroid();
    m_Centres.push_back({ crown.tooth, centre });
    for (const PointType & point : crown.surface->points)
    {
      m_Cells[Key(ToCell(point))].push_back({ point, tooth });
    }
  }

  ToothCode
  Find(const PointType & point) const
  {
    double     best = Reach * Reach;
    double     bestCentre = std::numeric_limits<double>::max();
    ToothCode  found;
    const auto cell = ToCell(point);
    CellType   near;
    for (near[0] = cell[0] - 1; near[0] <= cell[0] + 1; ++near[0])
    {
      for (near[1] = cell[1] - 1; near[1] <= cell[1] + 1; ++near[1])
      {
        for (near[2] = cell[2] - 1; near[2] <= cell[2] + 1; ++near[2])
        {
          const auto entries = m_Cells.find(Key(near));
          if (entries == m_Cells.end())
          {
            continue;
          }
          for (const EntryType & entry : entries->second)
          {
            const double distance = SquaredDistance(entry.point, point);
            const double centre = SquaredDistance(m_Centres[entry.tooth].centre, point);
            // Crowns by a textbook's width overlap: of two that have the point it is the nearer one's.
            if (distance < best || (distance == best && centre < bestCentre))
            {
              best = distance;
              bestCentre = centre;
              found = m_Centres[entry.tooth].code;
            }
          }
        }
      }
    }
    return found;
  }

private:
  using CellType = std::array<std::int64_t, 3>;
  struct EntryType
  {
    PointType     point;
    std::uint32_t tooth;
  };
  struct CentreType
  {
    ToothCode code;
    PointType centre;
  };

  static CellType
  ToCell(const PointType & point)
  {
    CellType cell;
    for (unsigned int d = 0; d < 3; ++d)
    {
      cell[d] = static_cast<std::int64_t>(std::floor(point[d] / Reach));
    }
    return cell;
  }
  /** Cells that share a key are an arch's length apart: what is in the wrong one is beyond the reach. */
  static std::uint64_t
  Key(const CellType & cell)
  {
    std::uint64_t key = 0;
    for (const std::int64_t index : cell)
    {
      key = (key << 20) | (static_cast<std::uint64_t>(index) & 0xfffff);
    }
    return key;
  }

  std::vector<CentreType>                                   m_Centres;
  std::unordered_map<std::uint64_t, std::vector<EntryType>> m_Cells;
};

/** One side of a jaw. */
struct SideType
{
  std::unique_ptr<MeshSilhouette> silhouette;
  bool                            isRight{ true };
};

struct JawModel
{
  std::vector<SideType> sides;
  ToothIndex            teeth;
};
} // namespace CrownDraftParts

namespace
{
using CrownDraftParts::JawModel;
using CrownDraftParts::SideType;

/** A contour of one point a tooth: the filter reads codes alone. */
DentalContour::Pointer
MakeCodes(JawEnum jaw)
{
  auto contour = DentalContour::New();
  for (unsigned int position = 1; position <= 8; ++position)
  {
    DentalContour::PointType origin;
    origin.Fill(0.0);
    contour->AddPolyline({ origin }, ToothCode((jaw == JawEnum::Upper ? 10 : 40) + position));
  }
  return contour;
}

TriangleSurface
SelectSide(const TriangleSurface & surface, const std::vector<double> & lateral, bool isRight)
{
  TriangleSurface side;
  side.points = surface.points;
  for (const auto & triangle : surface.triangles)
  {
    const double y = (lateral[triangle[0]] + lateral[triangle[1]] + lateral[triangle[2]]) / 3.0;
    if (isRight ? y < MidlineMargin : y > -MidlineMargin)
    {
      side.triangles.push_back(triangle);
    }
  }
  return side;
}

/** The centre of projection: M c + p = 0 for the matrix (M | p). */
PointType
FindSource(const std::array<double, 12> & rows)
{
  const auto determinant = [](const PointType & a, const PointType & b, const PointType & c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  };
  std::array<PointType, 4> columns;
  for (unsigned int column = 0; column < 4; ++column)
  {
    columns[column] = { { rows[column], rows[4 + column], rows[8 + column] } };
  }
  const PointType minus{ { -columns[3][0], -columns[3][1], -columns[3][2] } };
  const double    whole = determinant(columns[0], columns[1], columns[2]);
  return { { determinant(minus, columns[1], columns[2]) / whole,
             determinant(columns[0], minus, columns[2]) / whole,
             determinant(columns[0], columns[1], minus) / whole } };
}
} // namespace

class CrownDraftSource::Implementation
{
public:
  std::map<JawEnum, CrownDraftParts::JawModel> jaws;
};

CrownDraftSource::CrownDraftSource(const DentalCaseData & data)
{
  auto implementation = std::make_unique<Implementation>();
  auto axis = UMidlineDentalAxisFilter<MeshType>::New();
  axis->SetUpperMesh(data.upper.mesh);
  axis->SetLowerMesh(data.lower.mesh);
  axis->SetJawsShareFrame(ToJawsShareFrame(data.description.occlusion));
  axis->RefineMidlineOn();
  axis->RequireArchesOff();
  axis->TransformMeshesOff();
  axis->Update();
  // Of landmarks at another tooth's place, off the scan or all at one place, a draft would get another tooth's code.
  std::vector<std::string> unusable;
  if (data.landmarks3D.IsNotNull())
  {
    auto checks = ScanCheckFilter::New();
    checks->SetUpperMesh(data.upper.mesh);
    checks->SetLowerMesh(data.lower.mesh);
    checks->SetFrames(axis->GetFrameOutput());
    checks->SetLandmarks(data.landmarks3D);
    checks->SetMillimetresPerUnit(data.description.millimetresPerUnit);
    checks->Update();
    unusable = checks->GetUnusableLandmarks();
  }
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    const bool upper = jaw == JawEnum::Upper;
    auto *     frame = upper ? axis->GetUpperTransformOutput() : axis->GetLowerTransformOutput();
    const auto mesh = data.GetJaw(jaw).mesh;
    if (mesh.IsNull() || frame->Get() == nullptr)
    {
      continue;
    }
    auto       filter = ToothCrownFilter::New();
    const auto codes = MakeCodes(jaw);
    filter->SetLabels(jaw, data.GetJaw(jaw).labels);
    if (upper)
    {
      filter->SetUpperContour(codes);
      filter->SetUpperMesh(mesh);
      filter->SetUpperFrame(frame);
    }
    else
    {
      filter->SetLowerContour(codes);
      filter->SetLowerMesh(mesh);
      filter->SetLowerFrame(frame);
    }
    if (data.landmarks3D.IsNotNull())
    {
      filter->SetScanLandmarks(data.landmarks3D);
      filter->SetUnusableLandmarks(unusable);
      filter->SetMillimetresPerUnit(data.description.millimetresPerUnit);
    }
    filter->SetExcludedTeeth(data.description.excludedTeeth);
    filter->Update();
    JawModel & model = implementation->jaws[jaw];
    for (const auto & crown : filter->GetOutput()->GetCrowns())
    {
      model.teeth.Add(crown);
    }
    const TriangleSurface surface = MakeTriangleSurface(mesh.GetPointer());
    std::vector<double>   lateral;
    for (const PointType & point : surface.points)
    {
      MeshType::PointType place;
      for (unsigned int d = 0; d < 3; ++d)
      {
        place[d] = static_cast<float>(point[d]);
      }
      lateral.push_back(frame->Get()->TransformPoint(place)[1]);
    }
    for (const bool isRight : { true, false })
    {
      model.sides.push_back({ std::make_unique<MeshSilhouette>(SelectSide(surface, lateral, isRight)), isRight });
    }
  }
  m_Implementation = std::move(implementation);
}

CrownDraftSource::~CrownDraftSource() = default;

CrownDraftSource::DraftsType
CrownDraftSource::Compute(const CaseResult & result) const
{
  DraftsType drafts;
  for (const auto & [jaw, model] : m_Implementation->jaws)
  {
    const auto found = result.jaws.find(jaw);
    if (found == result.jaws.end() || !found->second.registered || !result.geometry->HasPixelSpacing())
    {
      continue;
    }
    const auto & spacing = result.geometry->GetPixelSpacing();
    const double facing = result.geometry->GetFacingSign();
    // Of the mesh in mm, to a picture with u anterior in units of a quarter of a millimetre.
    const std::array<double, 2> factors{ { facing * spacing[0] / Unit, spacing[1] / Unit } };
    PerspectiveProjection       projection;
    for (unsigned int i = 0; i < 12; ++i)
    {
      const double perMillimetre = i % 4 < 3 ? 1.0 / result.data->description.millimetresPerUnit : 1.0;
      projection.matrix[i] = found->second.projection[i] * perMillimetre * (i < 8 ? factors[i / 4] : 1.0);
    }
    projection.source = FindSource(projection.matrix);
    OpenSilhouetteOptions options;
    options.jaw = jaw;
    options.pitch = found->second.pose ? found->second.pose->parameters[0] : 0.0;
    for (const SideType & side : model.sides)
    {
      const OpenSilhouette outline = ComputeOpenSilhouette(*side.silhouette, projection, options);
      // By tooth the longest piece; a tooth that another one hides in its middle is drawn on one side of it.
      std::map<std::uint8_t, std::pair<std::size_t, std::size_t>> pieces;
      std::size_t                                                 begin = 0;
      ToothCode                                                   current;
      const auto                                                  finish = [&](std::size_t end) {
        auto & piece = pieces[current.GetFDI()];
        if (current.IsKnown() && end - begin > piece.second - piece.first)
        {
          piece = { begin, end };
        }
      };
      std::size_t run = 0;
      for (std::size_t i = 0; i < outline.Size(); ++i)
      {
        const bool starts = run < outline.runs.size() && outline.runs[run] == i;
        run += starts ? 1 : 0;
        const ToothCode tooth = model.teeth.Find(outline.rim[i]);
        // The strip beyond the midline shows the neighbour.
        const ToothCode own = tooth.IsKnown() && tooth.IsRight() == side.isRight ? tooth : ToothCode();
        if (starts || own != current)
        {
          finish(i);
          begin = i;
          current = own;
        }
      }
      finish(outline.Size());
      for (const auto & entry : pieces)
      {
        const auto [first, last] = entry.second;
        const double length = last > first ? static_cast<double>(last - first - 1) * options.spacing * Unit : 0.0;
        if (entry.first == 0 || length < ShortestDraft)
        {
          continue;
        }
        const auto                  count = static_cast<std::size_t>(std::lround(length / PointSpacing)) + 1;
        DentalContour::PolylineType draft;
        draft.code = ToothCode(entry.first);
        for (std::size_t k = 0; k < count; ++k)
        {
          const std::size_t        i = first + (last - first - 1) * k / (count - 1);
          DentalContour::PointType point;
          point[0] = outline.u[i] / factors[0];
          point[1] = outline.v[i] / factors[1];
          draft.points.push_back(point);
        }
        drafts[jaw].push_back(draft);
      }
    }
  }
  return drafts;
}
} // namespace itk
