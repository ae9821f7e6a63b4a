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
#include "itkDentalContour.h"

#include "itkLineCell.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace
{
using ContourType = itk::DentalContour;

ContourType::PointType
P(double u, double v)
{
  ContourType::PointType point;
  point[0] = u;
  point[1] = v;
  return point;
}
} // namespace

TEST(DentalContour, GivesBackItsPolylines)
{
  const auto contour = ContourType::New();
  contour->AddPolyline({ P(0, 0), P(3, 4) }, itk::ToothCode(11));
  contour->AddPolyline({ P(10, 0), P(11, 0), P(11, 1), P(10, 1) }, itk::ToothCode(12), true);
  contour->AddPolyline({ P(20, 20) }, itk::ToothCode(13));
  contour->AddPolyline({ P(30, 0), P(30, 2) });
  contour->AddPolyline(std::vector<ContourType::PointType>{});

  EXPECT_EQ(contour->GetNumberOfPoints(), 9u);
  EXPECT_EQ(contour->GetNumberOfCells(), 1u + 4u + 1u);
  EXPECT_DOUBLE_EQ(contour->GetLength(), 5.0 + 4.0 + 2.0);

  const auto polylines = contour->GetPolylines();
  ASSERT_EQ(polylines.size(), 4u);
  EXPECT_EQ(polylines[0].code, itk::ToothCode(11));
  EXPECT_EQ(polylines[0].points.size(), 2u);
  EXPECT_FALSE(polylines[0].closed);
  EXPECT_TRUE(polylines[1].closed);
  EXPECT_EQ(polylines[1].points.size(), 4u);
  EXPECT_FALSE(polylines[2].code.IsKnown());
  // The lone point comes last.
  EXPECT_EQ(polylines[3].code, itk::ToothCode(13));
  EXPECT_EQ(polylines[3].points.size(), 1u);
  EXPECT_TRUE(polylines[3].weights.empty());
}

TEST(DentalContour, ReadsPolylinesOfAPlainMesh)
{
  const auto contour = ContourType::New();
  for (unsigned int i = 0; i < 3; ++i)
  {
    contour->SetPoint(i, P(i, 0));
  }
  for (unsigned int i = 0; i < 2; ++i)
  {
    ContourType::CellAutoPointer cell;
    cell.TakeOwnership(new itk::LineCell<ContourType::CellType>);
    cell->SetPointId(0, i);
    cell->SetPointId(1, i + 1);
    contour->SetCell(i, cell);
  }
  const auto polylines = contour->GetPolylines();
  ASSERT_EQ(polylines.size(), 1u);
  EXPECT_EQ(polylines[0].points.size(), 3u);
  EXPECT_FALSE(polylines[0].code.IsKnown());
}

TEST(DentalContour, CarriesWeightsWhereGiven)
{
  const auto contour = ContourType::New();
  contour->AddPolyline({ P(0, 0), P(1, 0) });
  ContourType::PolylineType uncertain;
  uncertain.points = { P(5, 0), P(6, 0) };
  uncertain.weights = { 0.25, 1.0 };
  contour->AddPolyline(uncertain);
  contour->AddPolyline({ P(9, 0), P(9, 1) });
  EXPECT_EQ(contour->GetPointWeight(0), 1.0);
  EXPECT_EQ(contour->GetPointWeight(2), 0.25);
  EXPECT_EQ(contour->GetPointWeight(5), 1.0);
  EXPECT_EQ(contour->GetPolylines()[1].weights, uncertain.weights);

  const auto copy = ContourType::New();
  copy->Graft(contour);
  EXPECT_EQ(copy->GetPointWeight(2), 0.25);
  contour->Initialize();
  EXPECT_EQ(contour->GetPolylines().size(), 0u);
}

TEST(DentalContour, RefusesWhatIsNoContour)
{
  const auto contour = ContourType::New();
  EXPECT_THROW(contour->AddPolyline({ P(0, 0), P(1, 1) }, itk::ToothCode(), true), itk::ExceptionObject);
  EXPECT_THROW(contour->AddPolyline({ P(0, std::numeric_limits<double>::quiet_NaN()) }), itk::ExceptionObject);
  ContourType::PolylineType polyline;
  polyline.points = { P(0, 0), P(1, 0) };
  polyline.weights = { 2.0, 1.0 };
  EXPECT_THROW(contour->AddPolyline(polyline), itk::ExceptionObject);
  polyline.weights = { 1.0 };
  EXPECT_THROW(contour->AddPolyline(polyline), itk::ExceptionObject);
  EXPECT_EQ(contour->GetNumberOfPoints(), 0u);
}

TEST(DentalContour, TellsWhatShareOfItIsDrafted)
{
  const auto contour = ContourType::New();
  EXPECT_EQ(contour->GetDraftedShare(), 0.0);
  contour->AddPolyline({ P(0, 0), P(1, 0), P(2, 0) });
  EXPECT_EQ(contour->GetDraftedShare(), 0.0);
  ContourType::PolylineType draft;
  draft.points = { P(5, 0), P(6, 0), P(7, 0) };
  draft.drafted = true;
  // What does not count is no share.
  draft.weights = { 1.0, 0.0, 0.5 };
  contour->AddPolyline(draft);
  contour->AddPolyline({ P(9, 0), P(9, 1), P(9, 2) });
  EXPECT_EQ(contour->GetDraftedShare(), 2.0 / 8.0);
  EXPECT_FALSE(contour->IsPointDrafted(2));
  EXPECT_TRUE(contour->IsPointDrafted(3));
  EXPECT_FALSE(contour->IsPointDrafted(6));
  const auto polylines = contour->GetPolylines();
  ASSERT_EQ(polylines.size(), 3u);
  EXPECT_FALSE(polylines[0].drafted);
  EXPECT_TRUE(polylines[1].drafted);
  EXPECT_FALSE(polylines[2].drafted);

  const auto copy = ContourType::New();
  copy->Graft(contour);
  EXPECT_EQ(copy->GetDraftedShare(), 2.0 / 8.0);
  contour->Initialize();
  EXPECT_FALSE(contour->IsPointDrafted(3));
}

TEST(DentalContour, CarriesSigmasAndKindsWhereGiven)
{
  using OutlineEnum = ContourType::OutlineEnum;
  const auto contour = ContourType::New();
  contour->AddPolyline({ P(0, 0), P(1, 0) });
  EXPECT_TRUE(contour->GetPolylines()[0].sigmas.empty());
  ContourType::PolylineType tooth;
  tooth.points = { P(5, 0), P(6, 0), P(6, 5) };
  tooth.closed = true;
  tooth.sigmas = { 0.5, 1.0, 2.0 };
  tooth.outline = OutlineEnum::Tooth;
  contour->AddPolyline(tooth);
  contour->AddPolyline({ P(9, 0), P(9, 1) });
  EXPECT_EQ(contour->GetPointSigma(0), 0.0);
  EXPECT_EQ(contour->GetPointSigma(4), 2.0);
  EXPECT_EQ(contour->GetPointSigma(6), 0.0);
  const auto polylines = contour->GetPolylines();
  ASSERT_EQ(polylines.size(), 3u);
  EXPECT_EQ(polylines[0].outline, OutlineEnum::Unspecified);
  EXPECT_EQ(polylines[1].outline, OutlineEnum::Tooth);
  EXPECT_EQ(polylines[1].sigmas, tooth.sigmas);
  EXPECT_EQ(polylines[2].outline, OutlineEnum::Unspecified);

  const auto copy = ContourType::New();
  copy->Graft(contour);
  EXPECT_EQ(copy->GetPointSigma(4), 2.0);
  EXPECT_EQ(copy->GetPointOutline(4), OutlineEnum::Tooth);
  contour->Initialize();
  EXPECT_EQ(contour->GetPointSigma(4), 0.0);

  for (const double bad : { -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN() })
  {
    ContourType::PolylineType polyline;
    polyline.points = { P(0, 0) };
    polyline.sigmas = { bad };
    EXPECT_THROW(contour->AddPolyline(polyline), itk::ExceptionObject);
  }
  EXPECT_EQ(ContourType::OutlineFromString("labial"), OutlineEnum::Labial);
  EXPECT_THROW(ContourType::OutlineFromString("root"), std::invalid_argument);
}

namespace
{
ContourType::NormalType
N(double u, double v)
{
  ContourType::NormalType normal;
  normal[0] = u;
  normal[1] = v;
  return normal;
}

ContourType::RimPointType
R(double x, double y, double z)
{
  ContourType::RimPointType point;
  point[0] = x;
  point[1] = y;
  point[2] = z;
  return point;
}

/** A silhouette of two teeth, a drawing that knows nothing, and a silhouette whose last point alone is known. */
ContourType::Pointer
MakeSilhouettes()
{
  auto                      contour = ContourType::New();
  ContourType::PolylineType first;
  first.points = { P(0, 0), P(1, 0), P(2, 0) };
  first.normals = { N(0, -1), N(0.6, -0.8), N(1, 0) };
  first.rimPoints = { R(1, 2, 3), R(4, 5, 6), R(7, 8, 9) };
  first.teeth = { itk::ToothCode(11), itk::ToothCode(11), itk::ToothCode(12) };
  contour->AddPolyline(first);
  contour->AddPolyline({ P(10, 0), P(11, 0), P(11, 1) }, itk::ToothCode(13), true);
  const double              unknown = std::numeric_limits<double>::quiet_NaN();
  ContourType::PolylineType last;
  last.points = { P(20, 0), P(21, 0) };
  last.normals = { N(0, 0), N(-1, 0) };
  last.rimPoints = { R(unknown, unknown, unknown), R(-1, -2, -3) };
  contour->AddPolyline(last);
  return contour;
}

void
ExpectSilhouettes(const ContourType & contour)
{
  const auto polylines = contour.GetPolylines();
  ASSERT_EQ(polylines.size(), 3u);
  EXPECT_EQ(polylines[0].normals, (std::vector<ContourType::NormalType>{ N(0, -1), N(0.6, -0.8), N(1, 0) }));
  EXPECT_EQ(polylines[0].rimPoints, (std::vector<ContourType::RimPointType>{ R(1, 2, 3), R(4, 5, 6), R(7, 8, 9) }));
  EXPECT_EQ(polylines[0].code, itk::ToothCode(11)) << "that of the first point";
  EXPECT_EQ(polylines[0].teeth,
            (std::vector<itk::ToothCode>{ itk::ToothCode(11), itk::ToothCode(11), itk::ToothCode(12) }));
  EXPECT_TRUE(polylines[1].normals.empty());
  EXPECT_TRUE(polylines[1].rimPoints.empty());
  EXPECT_TRUE(polylines[1].teeth.empty()) << "all of one tooth";
  EXPECT_EQ(polylines[1].code, itk::ToothCode(13));
  ASSERT_EQ(polylines[2].normals.size(), 2u);
  EXPECT_EQ(polylines[2].normals[0], N(0, 0));
  EXPECT_EQ(polylines[2].normals[1], N(-1, 0));
  ASSERT_EQ(polylines[2].rimPoints.size(), 2u);
  EXPECT_TRUE(std::isnan(polylines[2].rimPoints[0][2]));
  EXPECT_EQ(polylines[2].rimPoints[1], R(-1, -2, -3));
}
} // namespace

TEST(DentalContour, CarriesWhatASilhouetteKnowsOfItsPoints)
{
  const auto contour = MakeSilhouettes();
  ExpectSilhouettes(*contour);
  EXPECT_TRUE(contour->HasRimPoints());
  EXPECT_EQ(contour->GetRimPoint(1), R(4, 5, 6));
  EXPECT_TRUE(std::isnan(contour->GetRimPoint(3)[0])) << "of the drawing";
  EXPECT_EQ(contour->GetPointNormal(7), N(-1, 0));
  EXPECT_EQ(contour->GetPointNormal(3), N(0, 0));
  EXPECT_EQ(contour->GetToothCode(2), itk::ToothCode(12));
  // From polylines it comes out as it went in, and by Graft() too.
  auto again = ContourType::New();
  for (const auto & polyline : contour->GetPolylines())
  {
    again->AddPolyline(polyline);
  }
  ExpectSilhouettes(*again);
  auto grafted = ContourType::New();
  grafted->Graft(contour);
  ExpectSilhouettes(*grafted);
  grafted->Initialize();
  EXPECT_FALSE(grafted->HasRimPoints());
  grafted->AddPolyline({ P(0, 0), P(1, 1) });
  EXPECT_TRUE(grafted->GetPolylines()[0].normals.empty());
}

TEST(DentalContour, RefusesWhatIsNoSilhouette)
{
  const auto                contour = ContourType::New();
  ContourType::PolylineType polyline;
  polyline.points = { P(0, 0), P(1, 0) };
  auto wrong = polyline;
  wrong.normals = { N(1, 0) };
  EXPECT_THROW(contour->AddPolyline(wrong), itk::ExceptionObject) << "one a point";
  wrong.normals = { N(1, 0), N(1, 1) };
  EXPECT_THROW(contour->AddPolyline(wrong), itk::ExceptionObject) << "no unit vector";
  wrong = polyline;
  wrong.rimPoints = { R(0, 0, 0), R(0, std::numeric_limits<double>::infinity(), 0) };
  EXPECT_THROW(contour->AddPolyline(wrong), itk::ExceptionObject);
  wrong.rimPoints = { R(0, 0, 0), R(0, std::numeric_limits<double>::quiet_NaN(), 0) };
  EXPECT_THROW(contour->AddPolyline(wrong), itk::ExceptionObject) << "unknown in part";
  wrong = polyline;
  wrong.teeth = { itk::ToothCode(11) };
  EXPECT_THROW(contour->AddPolyline(wrong), itk::ExceptionObject);
  EXPECT_EQ(contour->GetNumberOfPoints(), 0u);
}

TEST(DentalContour, AnAppendedPointFillsWhatIsNotKnown)
{
  const auto                polylines = MakeSilhouettes()->GetPolylines();
  ContourType::PolylineType joined;
  itk::AppendPoint(polylines[1], 0, joined);
  EXPECT_TRUE(joined.normals.empty());
  EXPECT_TRUE(joined.teeth.empty()) << "all of one tooth";
  itk::AppendPoint(polylines[0], 2, joined);
  itk::AppendPoint(polylines[1], 1, joined);
  EXPECT_EQ(joined.points, (std::vector<ContourType::PointType>{ P(10, 0), P(2, 0), P(11, 0) }));
  EXPECT_EQ(joined.normals, (std::vector<ContourType::NormalType>{ N(0, 0), N(1, 0), N(0, 0) }));
  ASSERT_EQ(joined.rimPoints.size(), 3u);
  EXPECT_TRUE(std::isnan(joined.rimPoints[0][0]));
  EXPECT_EQ(joined.rimPoints[1], R(7, 8, 9));
  EXPECT_TRUE(std::isnan(joined.rimPoints[2][0]));
  EXPECT_EQ(joined.code, itk::ToothCode(13)) << "that of the first point";
  EXPECT_EQ(joined.teeth, (std::vector<itk::ToothCode>{ itk::ToothCode(13), itk::ToothCode(12), itk::ToothCode(13) }));
}

TEST(DentalContour, APointIsAppendedWithAllThatWasDrawn)
{
  using OutlineEnum = ContourType::OutlineEnum;
  ContourType::PolylineType weighted;
  weighted.code = itk::ToothCode(11);
  weighted.points = { P(0, 0), P(1, 0) };
  weighted.weights = { 0.5, 0.25 };
  weighted.outline = OutlineEnum::Crown;
  ContourType::PolylineType measured;
  measured.code = itk::ToothCode(12);
  measured.points = { P(2, 0) };
  measured.sigmas = { 3.0 };
  measured.outline = OutlineEnum::Crown;
  ContourType::PolylineType joined;
  itk::AppendPoint(weighted, 1, joined);
  EXPECT_EQ(joined.outline, OutlineEnum::Crown);
  itk::AppendPoint(measured, 0, joined);
  itk::AppendPoint(weighted, 0, joined);
  EXPECT_EQ(joined.weights, (std::vector<double>{ 0.25, 1.0, 0.5 }));
  EXPECT_EQ(joined.sigmas, (std::vector<double>{ 0.0, 3.0, 0.0 }));
  EXPECT_EQ(joined.outline, OutlineEnum::Crown);
  // Two polylines of one tooth each: neither has `teeth`, and both codes stay.
  EXPECT_EQ(joined.teeth, (std::vector<itk::ToothCode>{ itk::ToothCode(11), itk::ToothCode(12), itk::ToothCode(11) }));
  EXPECT_EQ(joined.GetTooth(1), itk::ToothCode(12));
  EXPECT_EQ(measured.GetTooth(0), itk::ToothCode(12));
  measured.outline = OutlineEnum::Tooth;
  itk::AppendPoint(measured, 0, joined);
  EXPECT_EQ(joined.outline, OutlineEnum::Unspecified) << "of the whole nobody said one";
}

TEST(DentalContour, KeptPointsAreRunsThatBeginWithTheirOwnTooth)
{
  ContourType::PolylineType ring;
  ring.closed = true;
  ring.points = { P(0, 0), P(1, 0), P(2, 0), P(2, 1), P(1, 1) };
  ring.code = itk::ToothCode(11);
  ring.teeth = { itk::ToothCode(11), itk::ToothCode(12), itk::ToothCode(12), itk::ToothCode(13), itk::ToothCode(11) };
  const auto whole = itk::KeepPoints(ring, { true, true, true, true, true });
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_TRUE(whole[0].closed);
  EXPECT_EQ(whole[0].teeth, ring.teeth);
  EXPECT_TRUE(itk::KeepPoints(ring, { false, false, false, false, false }).empty());
  const auto runs = itk::KeepPoints(ring, { true, false, true, false, true });
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0].points, (std::vector<ContourType::PointType>{ P(2, 0) }));
  EXPECT_EQ(runs[0].code, itk::ToothCode(12));
  EXPECT_EQ(runs[1].points, (std::vector<ContourType::PointType>{ P(1, 1), P(0, 0) })) << "over its beginning";
  EXPECT_EQ(runs[1].code, itk::ToothCode(11));
  EXPECT_TRUE(runs[1].teeth.empty());
  EXPECT_FALSE(runs[1].closed);
  ring.closed = false;
  EXPECT_EQ(itk::KeepPoints(ring, { true, false, true, false, true }).size(), 3u);
}
