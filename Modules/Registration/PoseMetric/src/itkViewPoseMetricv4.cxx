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
#include "itkViewPoseMetricv4.h"

#include "itkPoseComposition.h"
#include "itkPoseStateBlocks.h"

#include <algorithm>

namespace itk
{
namespace
{
constexpr unsigned int Moved = 6;
constexpr unsigned int Kappa = 12;

PoseComposition
Compose(const LeastSquaresMetricv4::PositionType & x)
{
  PoseComposition::SixType pose;
  PoseComposition::SixType move;
  std::copy_n(x.begin(), 6, pose.begin());
  std::copy_n(x.begin() + Moved, 6, move.begin());
  return { pose, move };
}
} // namespace

ViewPoseMetricv4::ViewPoseMetricv4()
{
  this->SetJoins(JoinsEnum::Candidates);
}

void
ViewPoseMetricv4::SetTerm(TermType * term)
{
  if (m_Term != term)
  {
    m_Term = term;
    this->Modified();
  }
}

void
ViewPoseMetricv4::SetView(const std::string & name)
{
  if (m_View != name)
  {
    m_View = name;
    this->Modified();
  }
}

ViewPoseMetricv4::TermType &
ViewPoseMetricv4::VerifyTerm() const
{
  if (m_Term.IsNull())
  {
    itkExceptionMacro("No term: call SetTerm() with a metric of a pose that has the view's geometry.");
  }
  return *m_Term;
}

ViewPoseMetricv4::PositionType
ViewPoseMetricv4::MakeTermPosition(const PositionType & x)
{
  const PoseComposition composition = Compose(x);
  PositionType          position(composition.GetPose().begin(), composition.GetPose().end());
  position.push_back(x[Kappa]);
  return position;
}

ViewPoseMetricv4::MatrixType
ViewPoseMetricv4::MakeTermJacobian(const PositionType & x)
{
  const PoseComposition composition = Compose(x);
  MatrixType            jacobian(TermType::NumberOfPoseParameters, NumberOfViewParameters, 0.0);
  for (unsigned int i = 0; i < 6; ++i)
  {
    for (unsigned int k = 0; k < 12; ++k)
    {
      jacobian(i, k) = composition.GetJacobian()[12 * i + k];
    }
  }
  jacobian(PoseKappa, Kappa) = 1.0;
  return jacobian;
}

ModifiedTimeType
ViewPoseMetricv4::GetMTime() const
{
  const ModifiedTimeType time = Superclass::GetMTime();
  return m_Term.IsNull() ? time : std::max(time, m_Term->GetMTime());
}

ViewPoseMetricv4::BlocksType
ViewPoseMetricv4::DeclareBlocks() const
{
  return { PoseStateBlocks::MakePose(),
           PoseStateBlocks::MakePose(PoseStateBlocks::MakeMoveName(m_View)),
           PoseStateBlocks::MakeScale(PoseStateBlocks::MakeScaleName(m_View)) };
}

void
ViewPoseMetricv4::InitializeTerm()
{
  TermType & term = this->VerifyTerm();
  if (m_View.empty())
  {
    itkExceptionMacro("The view has no name: call SetView(), as in a case file's \"views\".");
  }
  term.SetValues(MakeTermPosition(this->GetState().GetValues()));
  term.Initialize();
}

SizeValueType
ViewPoseMetricv4::GetNumberOfResiduals() const
{
  return this->VerifyTerm().GetNumberOfResiduals();
}

void
ViewPoseMetricv4::ComputeResiduals(const PositionType & x, VectorType & residuals, MatrixType * jacobian) const
{
  if (jacobian == nullptr)
  {
    this->VerifyTerm().ComputeResiduals(MakeTermPosition(x), residuals, nullptr);
    return;
  }
  MatrixType own;
  this->VerifyTerm().ComputeResiduals(MakeTermPosition(x), residuals, &own);
  *jacobian = own * MakeTermJacobian(x);
}

double
ViewPoseMetricv4::ComputeValue(const PositionType & x) const
{
  return this->VerifyTerm().ComputeValue(MakeTermPosition(x));
}

void
ViewPoseMetricv4::ComputeGradient(const PositionType & x, VectorType & gradient) const
{
  VectorType own;
  this->VerifyTerm().ComputeGradient(MakeTermPosition(x), own);
  gradient = own * MakeTermJacobian(x);
}

void
ViewPoseMetricv4::AddSquaredMotion(const PositionType & from,
                                   const PositionType & to,
                                   double &             sum,
                                   double &             count) const
{
  this->VerifyTerm().AddSquaredMotion(MakeTermPosition(from), MakeTermPosition(to), sum, count);
}

void
ViewPoseMetricv4::SetReach(double standardDeviations)
{
  this->VerifyTerm().SetReach(standardDeviations);
}

void
ViewPoseMetricv4::SetKernelWidth(double width)
{
  this->VerifyTerm().SetKernelWidth(width);
}

void
ViewPoseMetricv4::SetRobustKernel(const RobustKernel * kernel)
{
  this->VerifyTerm().SetRobustKernel(kernel);
}

void
ViewPoseMetricv4::SetNoiseModel(const ResidualNoiseModel * model)
{
  this->VerifyTerm().SetNoiseModel(model);
}

void
ViewPoseMetricv4::SetNoiseLevels(const ContourNoiseLevels & levels, const ResidualNoiseModel * model)
{
  this->VerifyTerm().SetNoiseLevels(levels, model);
}

bool
ViewPoseMetricv4::GetNoiseLevels(ContourNoiseLevels & levels, const ResidualNoiseModel * model) const
{
  return this->VerifyTerm().GetNoiseLevels(levels, model);
}

double
ViewPoseMetricv4::ComputeKnownDeviance(const PositionType & x, bool noiseIsEstimated) const
{
  return this->VerifyTerm().ComputeKnownDeviance(MakeTermPosition(x), noiseIsEstimated);
}

void
ViewPoseMetricv4::UpdateNoiseCorrelation(const PositionType & x)
{
  this->VerifyTerm().UpdateNoiseCorrelation(MakeTermPosition(x));
}

void
ViewPoseMetricv4::AppendNoiseBlocks(const PositionType & x, std::vector<ResidualNoiseBlock> & blocks) const
{
  std::vector<ResidualNoiseBlock> own;
  this->VerifyTerm().AppendNoiseBlocks(MakeTermPosition(x), own);
  const MatrixType jacobian = MakeTermJacobian(x);
  for (ResidualNoiseBlock & block : own)
  {
    std::vector<double> columns(block.count * NumberOfViewParameters, 0.0);
    for (unsigned int k = 0; k < NumberOfViewParameters; ++k)
    {
      for (unsigned int a = 0; a < jacobian.rows(); ++a)
      {
        for (std::size_t i = 0; jacobian(a, k) != 0.0 && i < block.count; ++i)
        {
          columns[block.count * k + i] += block.jacobian[block.count * a + i] * jacobian(a, k);
        }
      }
    }
    block.jacobian.swap(columns);
    blocks.push_back(std::move(block));
  }
}

void
ViewPoseMetricv4::AddFixedInformation(const PositionType & x,
                                      MatrixType &         information,
                                      VectorType &         gradient,
                                      double &             value) const
{
  MatrixType own(TermType::NumberOfPoseParameters, TermType::NumberOfPoseParameters, 0.0);
  VectorType slope(TermType::NumberOfPoseParameters, 0.0);
  this->VerifyTerm().AddFixedInformation(MakeTermPosition(x), own, slope, value);
  const MatrixType jacobian = MakeTermJacobian(x);
  information += jacobian.transpose() * own * jacobian;
  gradient += slope * jacobian;
}

void
ViewPoseMetricv4::Hold(HoldEnum what)
{
  TermType & term = this->VerifyTerm();
  term.SetValues(MakeTermPosition(this->GetState().GetValues()));
  term.Hold(what);
}

LightObject::Pointer
ViewPoseMetricv4::InternalClone() const
{
  auto clone = Self::New();
  clone->m_View = m_View;
  if (m_Term.IsNotNull())
  {
    clone->m_Term = static_cast<TermType *>(CloneTerm(*m_Term).GetPointer());
  }
  clone->CopyState(*this);
  return clone.GetPointer();
}

void
ViewPoseMetricv4::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "View: " << m_View << std::endl;
  itkPrintSelfObjectMacro(Term);
}
} // namespace itk
