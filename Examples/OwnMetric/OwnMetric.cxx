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
// A metric of one's own, plugged into the registration method: 1 - exp(-d^2 / 2 sigma^2), averaged over the traced
// points. A traced point that has no counterpart costs at most 1.
#include "itkCephalometricGeometry.h"
#include "itkContourDistanceIndex.h"
#include "itkContourToContourMetricv4.h"
#include "itkDentalPhantomCaseSource.h"
#include "itkMeshSilhouetteContourSource.h"
#include "itkSilhouetteToContourRegistrationMethod.h"

#include <cmath>
#include <cstdlib>
#include <iostream>

/** Exponential distances from the tracing to the silhouette. */
class ExponentialContourMetric : public itk::ContourToContourMetricv4
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ExponentialContourMetric);
  using Self = ExponentialContourMetric;
  using Superclass = itk::ContourToContourMetricv4;
  using Pointer = itk::SmartPointer<Self>;
  itkNewMacro(Self);
  itkTypeMacro(ExponentialContourMetric, ContourToContourMetricv4);

  /** Pixels. Modified() is called by the macro, so that the registration runs anew. */
  itkSetMacro(Sigma, double);
  itkGetConstMacro(Sigma, double);

protected:
  ExponentialContourMetric() = default;

  /** Called once a run: the moving contour is searched, the fixed points are its queries. */
  void
  InitializeContours(const itk::ContourArrays & fixed, const itk::ContourArrays & moving) override
  {
    m_Fixed = fixed.points;
    m_Index.SetPoints(moving.points.data(), moving.GetNumberOfPoints());
  }

  /** The value at p = s R q + t, and its derivatives by s, angle, tx, ty. */
  MeasureType
  ComputeValue(const itk::ContourSimilarity & t, itk::ContourChamferKernel::GradientType * gradient) const override
  {
    const double c = std::cos(t.angle);
    const double s = std::sin(t.angle);
    double       sum = 0.0;
    if (gradient != nullptr)
    {
      gradient->fill(0.0);
    }
    const auto count = static_cast<double>(m_Fixed.size() / 2);
    for (std::size_t i = 0; i < m_Fixed.size(); i += 2)
    {
      // The search structure does not move: the fixed point goes into its frame.
      const double x = (m_Fixed[i] - t.tx) / t.scale;
      const double y = (m_Fixed[i + 1] - t.ty) / t.scale;
      const auto   near = m_Index.FindNearest(c * x + s * y, c * y - s * x);
      // The nearest silhouette point in the radiograph, and from the fixed point to it.
      const double rotatedX = c * near.x - s * near.y;
      const double rotatedY = s * near.x + c * near.y;
      const double dx = t.scale * rotatedX + t.tx - m_Fixed[i];
      const double dy = t.scale * rotatedY + t.ty - m_Fixed[i + 1];
      const double weight = std::exp(-0.5 * (dx * dx + dy * dy) / (m_Sigma * m_Sigma));
      sum += 1.0 - weight;
      if (gradient != nullptr)
      {
        const double f = weight / (m_Sigma * m_Sigma * count);
        (*gradient)[0] += f * (dx * rotatedX + dy * rotatedY);
        (*gradient)[1] += f * t.scale * (dy * rotatedX - dx * rotatedY);
        (*gradient)[2] += f * dx;
        (*gradient)[3] += f * dy;
      }
    }
    return sum / count;
  }

private:
  double                    m_Sigma{ 4.0 };
  std::vector<double>       m_Fixed;
  itk::ContourDistanceIndex m_Index;
};

int
main()
{
  try
  {
    // A phantom whose tracing is known; the head not turned, so that a similarity can fit.
    auto phantom = itk::DentalPhantomCaseSource::New();
    phantom->SetSeed(3);
    phantom->SetCohort(itk::DentalPhantomCaseSource::CohortEnum::Ideal);
    phantom->SetFrame(itk::DentalPhantomCaseSource::FrameEnum::Anatomical);
    phantom->MakeRadiographOff();
    phantom->Update();

    // The silhouette where it belongs: the true geometry projects it onto the tracing.
    auto silhouette = itk::MeshSilhouetteContourSource<itk::Mesh<float, 3>>::New();
    silhouette->SetInput(phantom->GetMesh(0));
    silhouette->SetGeometry(phantom->GetTrueGeometry(0));
    silhouette->SetNumberOfPoints(2000);

    auto registration = itk::SilhouetteToContourRegistrationMethod::New();
    registration->SetFixedContour(phantom->GetTracing(0));
    registration->SetMovingContour(silhouette->GetOutput());
    registration->SetPixelSpacing(phantom->GetTrueGeometry(0)->GetPixelSpacing()[0]);
    // From 20 px, 3 degrees and 4 % off.
    auto start = itk::Similarity2DTransform<double>::New();
    silhouette->Update();
    itk::DentalContour::PointType centre;
    centre.Fill(0.0);
    const auto points = silhouette->GetOutput()->GetPolylines().front().points;
    for (const auto & point : points)
    {
      for (unsigned int d = 0; d < 2; ++d)
      {
        centre[d] += point[d] / static_cast<double>(points.size());
      }
    }
    start->SetCenter(centre);
    start->SetScale(1.04);
    start->SetAngle(0.05);
    itk::Vector<double, 2> shift;
    shift[0] = 16.0;
    shift[1] = 12.0;
    start->SetTranslation(shift);
    registration->SetInitialTransform(start);

    for (const bool own : { false, true })
    {
      itk::ContourToContourMetricv4::Pointer metric; // none: the paper's symmetric Chamfer
      if (own)
      {
        metric = ExponentialContourMetric::New();
      }
      registration->SetMetric(metric);
      registration->Update();
      // The truth is the identity: how far are the silhouette's points moved?
      double error = 0.0;
      for (const auto & point : points)
      {
        error += registration->GetTransform()->TransformPoint(point).EuclideanDistanceTo(point) /
                 static_cast<double>(points.size());
      }
      std::cout << (own ? "own" : "chamfer") << " error px: " << error << std::endl;
    }
  }
  catch (const itk::ExceptionObject & error)
  {
    std::cerr << error.GetDescription() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
