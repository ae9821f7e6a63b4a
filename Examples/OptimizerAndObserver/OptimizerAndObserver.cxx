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
// Three optimizers on one registration, and observers: one of the toolkit's that records, one of our own that ends a
// run.
#include "itkAmoebaOptimizerv4.h"
#include "itkDentalPhantomCaseSource.h"
#include "itkLBFGSBOptimizerv4.h"
#include "itkMeshSilhouetteContourSource.h"
#include "itkOnePlusOneEvolutionaryOptimizerv4.h"
#include "itkRegistrationIterationCommand.h"
#include "itkSilhouetteToContourRegistrationMethod.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <limits>

namespace
{
/** Ends a registration when the metric's value hardly falls any more. */
class PatienceCommand : public itk::Command
{
public:
  using Self = PatienceCommand;
  using Pointer = itk::SmartPointer<Self>;
  itkNewMacro(Self);

  void
  Execute(itk::Object * caller, const itk::EventObject & event) override
  {
    auto * method = dynamic_cast<itk::SilhouetteToContourRegistrationMethod *>(caller);
    // A MultiResolutionIterationEvent is an IterationEvent too: compare the exact type.
    if (method == nullptr || typeid(event) != typeid(itk::IterationEvent))
    {
      return;
    }
    const double value = method->GetMetricValue();
    m_Waited = value < m_Best - 1e-3 ? 0 : m_Waited + 1;
    m_Best = std::min(m_Best, value);
    if (m_Waited > 400)
    {
      method->AbortGenerateDataOn();
    }
  }
  void
  Execute(const itk::Object *, const itk::EventObject &) override
  {}

private:
  double       m_Best{ std::numeric_limits<double>::max() };
  unsigned int m_Waited{ 0 };
};
} // namespace

int
main(int argc, char * argv[])
{
  if (argc != 2)
  {
    std::cerr << "Usage: " << argv[0] << " convergence.csv" << std::endl;
    return EXIT_FAILURE;
  }
  try
  {
    auto phantom = itk::DentalPhantomCaseSource::New();
    phantom->SetSeed(3);
    phantom->SetCohort(itk::DentalPhantomCaseSource::CohortEnum::Ideal);
    phantom->SetFrame(itk::DentalPhantomCaseSource::FrameEnum::Anatomical);
    phantom->MakeRadiographOff();
    auto silhouette = itk::MeshSilhouetteContourSource<itk::Mesh<float, 3>>::New();
    phantom->Update();
    silhouette->SetInput(phantom->GetMesh(0));
    silhouette->SetGeometry(phantom->GetNominalGeometry());
    silhouette->SetNumberOfPoints(441);

    const std::pair<const char *, itk::ObjectToObjectOptimizerBaseTemplate<double>::Pointer> optimizers[] = {
      { "LBFGSB", itk::LBFGSBOptimizerv4::New().GetPointer() },
      { "Amoeba", itk::AmoebaOptimizerv4::New().GetPointer() },
      { "OnePlusOne", itk::OnePlusOneEvolutionaryOptimizerv4<double>::New().GetPointer() }
    };
    std::ofstream table(argv[1]);
    table << "optimizer,level,step,value\n";
    for (const auto & entry : optimizers)
    {
      auto registration = itk::SilhouetteToContourRegistrationMethod::New();
      registration->SetFixedContour(phantom->GetTracing(0));
      registration->SetMovingContour(silhouette->GetOutput());
      registration->SetOptimizer(entry.second);
      auto record = itk::RegistrationIterationCommand::New();
      record->Observe(registration);
      registration->AddObserver(itk::IterationEvent(), PatienceCommand::New());
      try
      {
        registration->Update();
      }
      catch (const itk::ProcessAborted &)
      {
        // Our observer ended it; the levels that were completed stay.
      }
      std::size_t step = 0;
      double      best = std::numeric_limits<double>::max();
      for (const auto & event : record->GetRecords())
      {
        if (event.kind == itk::RegistrationIterationCommand::KindEnum::Iteration)
        {
          table << entry.first << ',' << event.level << ',' << step++ << ',' << event.value << '\n';
          best = std::min(best, event.value);
        }
      }
      std::cout << entry.first << " metric px: " << best << std::endl;
      std::cerr << entry.first << ": " << step << " steps, " << registration->GetOptimizerStopConditionDescription()
                << std::endl;
    }
  }
  catch (const itk::ExceptionObject & error)
  {
    std::cerr << error.GetDescription() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
