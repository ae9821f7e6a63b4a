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
#include "itkExperimentPlan.h"
#include "itkExperimentTable.h"

#include "itkDentalInputError.h"
#include "itkReproducibleRandom.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace itk
{
namespace
{
using Json = nlohmann::ordered_json;
using Complex = std::complex<double>;
using TransformType = ExperimentRunner::TransformType;
using PairsType = std::vector<std::pair<std::array<double, 2>, std::array<double, 2>>>;

constexpr unsigned int NumberOfBins = 10;
constexpr double       BinWidth = 2.0;
constexpr double       AccurateWithin = 2.0;
constexpr double       ConvergedWithin = 1.0;
constexpr double       SuccessOfRange = 0.95;
constexpr unsigned int StartStream = 911;
/** Methods by grey values are slow: the first cases stand for all. */
constexpr std::size_t NumberOfIntensityCases = 2;

/** p = linear q + shift. */
struct Similarity
{
  Complex linear;
  Complex shift;

  TransformType::Pointer
  ToTransform() const
  {
    auto                          transform = TransformType::New();
    TransformType::ParametersType parameters(4);
    parameters[0] = std::abs(linear);
    parameters[1] = std::arg(linear);
    parameters[2] = shift.real();
    parameters[3] = shift.imag();
    transform->SetParameters(parameters);
    return transform;
  }
};

Complex
ToComplex(const std::array<double, 2> & point)
{
  return { point[0], point[1] };
}

/** The best similarity there is: fitted to the landmarks. */
Similarity
FitToLandmarks(const PairsType & pairs)
{
  Complex qMean(0.0, 0.0);
  Complex pMean(0.0, 0.0);
  for (const auto & pair : pairs)
  {
    qMean += ToComplex(pair.first) / static_cast<double>(pairs.size());
    pMean += ToComplex(pair.second) / static_cast<double>(pairs.size());
  }
  Complex cross(0.0, 0.0);
  double  spread = 0.0;
  for (const auto & pair : pairs)
  {
    cross += std::conj(ToComplex(pair.first) - qMean) * (ToComplex(pair.second) - pMean);
    spread += std::norm(ToComplex(pair.first) - qMean);
  }
  const Complex linear = cross / spread;
  return { linear, pMean - linear * qMean };
}

double
MeanDisplacement(const PairsType & pairs, const Similarity & a, const Similarity & b)
{
  double sum = 0.0;
  for (const auto & pair : pairs)
  {
    const Complex q = ToComplex(pair.first);
    sum += std::abs((a.linear - b.linear) * q + a.shift - b.shift);
  }
  return sum / static_cast<double>(pairs.size());
}

/** A start in a random direction from the truth whose mean landmark displacement is the target (pixels): scale, turn
 * and shift each move the landmarks alike on average. Methods that keep the scale get the truth's. */
Similarity
DrawStart(
  const PairsType & pairs, const Similarity & truth, double target, bool keepsScale, ReproducibleRandom & random)
{
  Complex centre(0.0, 0.0);
  for (const auto & pair : pairs)
  {
    centre += ToComplex(pair.first) / static_cast<double>(pairs.size());
  }
  double reach = 0.0;
  for (const auto & pair : pairs)
  {
    reach += std::norm(truth.linear * (ToComplex(pair.first) - centre)) / static_cast<double>(pairs.size());
  }
  reach = std::sqrt(reach);
  double direction[4] = { random.Normal(), random.Normal(), random.Normal(), random.Normal() };
  if (keepsScale)
  {
    direction[0] = 0.0;
  }
  const auto at = [&](double amount) {
    const Complex factor = std::polar(std::exp(amount * direction[0] / reach), amount * direction[1] / reach);
    Similarity    start;
    start.linear = truth.linear * factor;
    start.shift =
      truth.linear * centre + truth.shift + amount * Complex(direction[2], direction[3]) - start.linear * centre;
    return start;
  };
  // The displacement grows with the amount: bisect.
  double low = 0.0;
  double high = 1.0;
  while (MeanDisplacement(pairs, truth, at(high)) < target && high < 1e4)
  {
    high *= 2.0;
  }
  for (unsigned int i = 0; i < 50; ++i)
  {
    const double middle = 0.5 * (low + high);
    (MeanDisplacement(pairs, truth, at(middle)) < target ? low : high) = middle;
  }
  return at(high);
}

double
MeanPixelSpacing(const CephalometricGeometry & geometry)
{
  return 0.5 * (geometry.GetPixelSpacing()[0] + geometry.GetPixelSpacing()[1]);
}

struct Outcome
{
  double displacement{ 0.0 };
  /** Infinite where not registered. */
  double error{ 0.0 };
  double fromReference{ 0.0 };
};

class CapturePlan : public ExperimentPlan
{
public:
  CapturePlan(const ExperimentCohort &              cohort,
              const std::vector<ExperimentMethod> & methods,
              unsigned int                          numberOfStarts)
    : ExperimentPlan(cohort, methods)
    , m_NumberOfStarts(numberOfStarts)
  {}

  std::string
  Compute(std::size_t i, const std::string & key, const ExperimentMonitor & monitor) const override
  {
    const bool withIntensity = i < NumberOfIntensityCases;
    Json       json;
    json["key"] = key;
    json["id"] = this->GetCohort().GetId(i);
    json["methods"] = Json::object();
    json["notes"] = Json::array();
    const std::string failure = Try([&]() {
      const ExperimentCase experimentCase =
        this->GetCohort().Make(i, withIntensity && NeedsRadiograph(this->GetMethods()), monitor.GetAbort());
      ExperimentRunner runner(experimentCase);
      runner.SetAbort(monitor.GetAbort());
      std::vector<ToothCode::JawEnum> jaws;
      for (const ToothCode::JawEnum jaw : { ToothCode::JawEnum::Upper, ToothCode::JawEnum::Lower })
      {
        if (runner.HasJaw(jaw) && runner.GetLandmarkPairs(jaw).size() >= 2)
        {
          jaws.push_back(jaw);
        }
        else
        {
          json["notes"].push_back(std::string(ToString(jaw)) +
                                  " jaw: no scan, no tracing, or fewer than two landmarks on both");
        }
      }
      std::size_t methodsDone = 0;
      for (const ExperimentMethod & method : this->GetMethods())
      {
        if (method.kind == ExperimentMethod::KindEnum::Intensity && !withIntensity)
        {
          ++methodsDone;
          continue;
        }
        Json        outcomes = Json::array();
        std::size_t jawsDone = 0;
        const auto  partDone = [&](double part) {
          monitor.Advance((static_cast<double>(methodsDone) +
                           (static_cast<double>(jawsDone) + part) / static_cast<double>(jaws.size())) /
                          static_cast<double>(this->GetMethods().size()));
        };
        if (method.kind == ExperimentMethod::KindEnum::Pose)
        {
          // It searches everywhere: no start to give it, one run stands for all.
          const CaseResult result = runner.Run(method);
          for (const ToothCode::JawEnum jaw : jaws)
          {
            const auto   entry = result.jaws.find(jaw);
            const bool   known = entry != result.jaws.end() && entry->second.error;
            const double error = known ? entry->second.error->mean * MeanPixelSpacing(*result.geometry) : -1.0;
            outcomes.push_back({ -1.0, error, 0.0 });
          }
        }
        else
        {
          for (const ToothCode::JawEnum jaw : jaws)
          {
            this->RunJaw(runner, method, jaw, i, outcomes, partDone);
            ++jawsDone;
          }
        }
        ++methodsDone;
        json["methods"][method.name] = outcomes;
      }
    });
    if (!failure.empty())
    {
      json["methods"] = Json::object();
      json["notes"] = { failure };
    }
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
  }

  void
  Accept(std::size_t i, const std::string & text, const std::string & key) override
  {
    const Json json = Json::parse(text);
    if (json.at("key") != key)
    {
      throw std::invalid_argument("the record is of another experiment");
    }
    m_Outcomes.resize(this->GetCohort().size());
    std::map<std::string, std::vector<Outcome>> outcomes;
    for (const auto & method : json.at("methods").items())
    {
      for (const auto & item : method.value())
      {
        Outcome outcome{ item.at(0).get<double>(), item.at(1).get<double>(), item.at(2).get<double>() };
        if (outcome.error < 0.0)
        {
          outcome.error = std::numeric_limits<double>::infinity();
          outcome.fromReference = std::numeric_limits<double>::infinity();
        }
        outcomes[method.key()].push_back(outcome);
      }
    }
    std::string notes;
    for (const auto & note : json.at("notes"))
    {
      notes += "* " + this->GetCohort().GetId(i) + ": " + note.get<std::string>() + '\n';
    }
    m_Outcomes[i] = outcomes;
    m_Notes.resize(this->GetCohort().size());
    m_Notes[i] = notes;
  }

  std::map<std::string, std::string>
  MakeFiles() const override
  {
    if (std::all_of(m_Outcomes.begin(), m_Outcomes.end(), [](const auto & outcomes) { return outcomes.empty(); }))
    {
      itkDentalInputErrorMacro(
        this->GetCohort().GetId(0), "", "and every other case is unusable: " + m_Notes.front(), "see the first");
    }
    ExperimentTable bins({ "method", "from_mm", "to_mm", "starts", "accurate", "converged" });
    ExperimentTable ranges(
      { "method", "starts", "capture_range_accurate_mm", "capture_range_converged_mm", "accurate" });
    ExperimentTable markdown(
      { "Method", "starts", "capture range, accurate", "capture range, converged", "accurate, all starts" });
    for (const ExperimentMethod & method : this->GetMethods())
    {
      std::array<std::array<std::size_t, 3>, NumberOfBins> counts{};
      for (const auto & outcomes : m_Outcomes)
      {
        const auto found = outcomes.find(method.name);
        if (found == outcomes.end())
        {
          continue;
        }
        for (const Outcome & outcome : found->second)
        {
          const auto fill = [&](unsigned int bin) {
            ++counts[bin][0];
            counts[bin][1] += outcome.error <= AccurateWithin ? 1 : 0;
            counts[bin][2] += outcome.fromReference <= ConvergedWithin ? 1 : 0;
          };
          if (outcome.displacement < 0.0)
          {
            for (unsigned int bin = 0; bin < NumberOfBins; ++bin)
            {
              fill(bin);
            }
          }
          else
          {
            fill(std::min(NumberOfBins - 1, static_cast<unsigned int>(outcome.displacement / BinWidth)));
          }
        }
      }
      double      range[2] = { 0.0, 0.0 };
      bool        open[2] = { true, true };
      std::size_t starts = 0;
      std::size_t accurate = 0;
      for (unsigned int bin = 0; bin < NumberOfBins; ++bin)
      {
        const auto count = static_cast<double>(counts[bin][0]);
        starts += counts[bin][0];
        accurate += counts[bin][1];
        for (unsigned int kind = 0; kind < 2; ++kind)
        {
          open[kind] =
            open[kind] && count > 0.0 && static_cast<double>(counts[bin][1 + kind]) >= SuccessOfRange * count;
          if (open[kind])
          {
            range[kind] = BinWidth * (bin + 1);
          }
        }
        bins.AddRow({ method.name,
                      ExperimentTable::Number(BinWidth * bin, 1),
                      ExperimentTable::Number(BinWidth * (bin + 1), 1),
                      std::to_string(counts[bin][0]),
                      ExperimentTable::Number(static_cast<double>(counts[bin][1]) / count, 6),
                      ExperimentTable::Number(static_cast<double>(counts[bin][2]) / count, 6) });
      }
      const bool   free = method.kind == ExperimentMethod::KindEnum::Pose;
      const double share = static_cast<double>(accurate) / static_cast<double>(starts);
      ranges.AddRow({ method.name,
                      std::to_string(starts),
                      ExperimentTable::Number(range[0], 1),
                      ExperimentTable::Number(range[1], 1),
                      ExperimentTable::Number(share, 6) });
      markdown.AddRow({ method.title,
                        free ? "none needed" : std::to_string(starts),
                        ExperimentTable::Number(range[0], 0) + " mm",
                        free ? "-" : ExperimentTable::Number(range[1], 0) + " mm",
                        ExperimentTable::Number(100.0 * share, 1) + " %" });
    }
    std::ostringstream text;
    text
      << "# Capture range\n\n"
      << this->GetCohort().Describe() << ", both jaws, " << m_NumberOfStarts
      << " seeded starts a jaw (intensity-driven methods: the first "
      << std::min(NumberOfIntensityCases, this->GetCohort().size()) << " cases only), up to " << NumberOfBins * BinWidth
      << " mm from the similarity that fits the landmarks best, binned by the mean displacement of the landmarks "
         "(van de Kraats et al. 2005). Accurate: the mean landmark error ends within "
      << AccurateWithin << " mm. Converged: it ends within " << ConvergedWithin
      << " mm of where the method ends when it starts at the best similarity, right or wrong. The capture range is the "
         "end of the last bin with at least 95 % success, 0 where already the first has less. A method that "
         "searches everywhere needs no start: each bin holds its one result a jaw. Rigid methods keep the scale of "
         "their start and get the best one. The bounding box is a start and has none.\n\n"
      << markdown.ToMarkdown();
    std::string notes;
    for (const std::string & note : m_Notes)
    {
      notes += note;
    }
    if (!notes.empty())
    {
      text << "\nWhat is in no figure:\n\n" << notes;
    }
    return { { "capture.csv", bins.ToCSV() }, { "capture_range.csv", ranges.ToCSV() }, { "capture.md", text.str() } };
  }

private:
  void
  RunJaw(ExperimentRunner &                  runner,
         const ExperimentMethod &            method,
         ToothCode::JawEnum                  jaw,
         std::size_t                         number,
         Json &                              outcomes,
         const std::function<void(double)> & partDone) const
  {
    const PairsType  pairs = runner.GetLandmarkPairs(jaw, method.chain);
    const double     spacing = runner.GetMeanPixelSpacing(jaw);
    const bool       keepsScale = method.keepsScale;
    const Similarity truth = FitToLandmarks(pairs);
    const auto       endOf = [&](const Similarity & start, Similarity & end) {
      const JawResult result = runner.RunJaw(method, jaw, start.ToTransform());
      if (result.registered)
      {
        end.linear = std::polar(result.similarity.scale, result.similarity.rotation);
        end.shift = Complex(result.similarity.translation[0], result.similarity.translation[1]);
      }
      return result.registered;
    };
    Similarity         reference;
    const bool         hasReference = endOf(truth, reference);
    ReproducibleRandom random(this->GetCohort().seed + number,
                              StartStream + (jaw == ToothCode::JawEnum::Upper ? 0 : 1));
    for (unsigned int k = 0; k < m_NumberOfStarts; ++k)
    {
      partDone(static_cast<double>(k) / static_cast<double>(m_NumberOfStarts));
      const double     target = BinWidth * (k % NumberOfBins + random.Uniform());
      const Similarity start = DrawStart(pairs, truth, target / spacing, keepsScale, random);
      Similarity       end;
      if (!endOf(start, end))
      {
        outcomes.push_back({ target, -1.0, -1.0 });
        continue;
      }
      double error = 0.0;
      for (const auto & pair : pairs)
      {
        error += std::abs(end.linear * ToComplex(pair.first) + end.shift - ToComplex(pair.second));
      }
      error *= spacing / static_cast<double>(pairs.size());
      outcomes.push_back({ target, error, hasReference ? MeanDisplacement(pairs, end, reference) * spacing : 1e9 });
    }
  }

  unsigned int                                             m_NumberOfStarts;
  std::vector<std::map<std::string, std::vector<Outcome>>> m_Outcomes;
  /** A line each. */
  std::vector<std::string> m_Notes;
};
} // namespace

std::unique_ptr<ExperimentPlan>
MakeCapturePlan(const ExperimentCohort &              cohort,
                const std::vector<ExperimentMethod> & methods,
                unsigned int                          numberOfStarts)
{
  std::vector<ExperimentMethod> chosen;
  for (const ExperimentMethod & method : methods)
  {
    if (method.name != "bounding-box")
    {
      chosen.push_back(method);
    }
  }
  if (chosen.empty())
  {
    itkDentalInputErrorMacro(
      "--methods", "", "bounding-box is a start, and nothing that starts from one", "name another method");
  }
  return std::make_unique<CapturePlan>(cohort, chosen, numberOfStarts);
}
} // namespace itk
