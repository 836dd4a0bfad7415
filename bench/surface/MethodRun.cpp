#include "bench/surface/MethodRun.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <limits>

namespace asperity {

namespace {

using Clock = std::chrono::steady_clock;

double nanoseconds(Clock::duration taken) {
    return std::chrono::duration<double, std::nano>(taken).count();
}

/// Queries between two looks at the clock, which is too coarse for a fast one.
constexpr std::size_t kBlock = 50;
/// Slower queries are timed one by one: a block of them would take in what else the machine does,
/// and so make the method look slower than it is. [ns]
constexpr double kSlow = 1000.0;
constexpr double kNever = std::numeric_limits<double>::infinity();

/// One method's answers and best times so far.
struct Course {
    SearchMethod* method = nullptr;
    std::vector<SearchAnswer> answers;
    std::vector<double> times;   ///< of each query [ns]
    std::vector<double> blocks;  ///< of a query, mean over each block of them [ns]
};

Course courseOf(SearchMethod& method, std::size_t queries) {
    const std::size_t most = method.mostQueries();
    const std::size_t count = most == 0 ? queries : std::min(most, queries);
    return {.method = &method,
            .answers = std::vector<SearchAnswer>(count),
            .times = std::vector<double>(count, kNever),
            .blocks = std::vector<double>((count + kBlock - 1) / kBlock, kNever)};
}

void passInBlocks(const SearchWork& work, const Vector2& firstPoint, Course& course) {
    course.method->start(firstPoint);
    for (std::size_t block = 0; block < course.blocks.size(); ++block) {
        const std::size_t first = block * kBlock;
        const std::size_t last = std::min(first + kBlock, course.answers.size());
        const auto begin = Clock::now();
        for (std::size_t i = first; i < last; ++i) {
            course.answers[i] = course.method->next(work.centers[i]);
        }
        const double taken = nanoseconds(Clock::now() - begin);
        course.blocks[block] =
            std::min(course.blocks[block], taken / static_cast<double>(last - first));
    }
}

void pass(const SearchWork& work, const Vector2& firstPoint, double clock, Course& course) {
    course.method->start(firstPoint);
    for (std::size_t i = 0; i < course.times.size(); ++i) {
        const auto begin = Clock::now();
        course.answers[i] = course.method->next(work.centers[i]);
        const double taken = nanoseconds(Clock::now() - begin) - clock;
        course.times[i] = std::min(course.times[i], std::max(taken, 0.0));
    }
}

double medianOf(const Course& course) {
    const double single = summaryOf(course.times).median;
    return single < kSlow ? summaryOf(course.blocks).median : single;
}

MethodResult resultOf(const SearchWork& work, std::span<const GlobalReference::Nearest> truth,
                      const Course& course) {
    MethodResult result{.name = course.method->name(),
                        .median = medianOf(course),
                        .p99 = summaryOf(course.times).p99};
    for (std::size_t i = 0; i < course.answers.size(); ++i) {
        judge(work, i, course.answers[i], truth[i], result);
    }
    return result;
}

}  // namespace

double clockCost() {
    constexpr int kLooks = 2001;
    std::vector<double> times;
    times.reserve(kLooks);
    for (int i = 0; i < kLooks; ++i) {
        const auto begin = Clock::now();
        times.push_back(nanoseconds(Clock::now() - begin));
    }
    return summaryOf(times).median;
}

TimeSummary summaryOf(std::vector<double> times) {
    if (times.empty()) {
        return {};
    }
    std::sort(times.begin(), times.end());
    return {.median = times[times.size() / 2], .p99 = times[times.size() * 99 / 100]};
}

std::vector<GlobalReference::Nearest> referenceOf(const SearchWork& work) {
    const GlobalReference reference(*work.surface);
    std::vector<GlobalReference::Nearest> truth;
    truth.reserve(work.centers.size());
    for (const Vector3& center : work.centers) {
        truth.push_back(reference.nearest(center));
    }
    return truth;
}

double referenceDoubt(const SearchWork& work, std::span<const GlobalReference::Nearest> truth,
                      std::size_t stride) {
    const GlobalReference finer(*work.surface, {.samplesPerCell = 17, .skipsCells = false});
    double doubt = 0.0;
    for (std::size_t i = 0; i < work.centers.size(); i += stride) {
        doubt = std::max(doubt, truth[i].distance - finer.nearest(work.centers[i]).distance);
    }
    return doubt;
}

void judge(const SearchWork& work, std::size_t query, const SearchAnswer& answer,
           const GlobalReference::Nearest& truth, MethodResult& result) {
    const Vector3& center = work.centers[query];
    const HeightSample sample = work.surface->at(answer.position.x(), answer.position.y());
    const Vector3 point(answer.position.x(), answer.position.y(), sample.height);
    const double excess = (center - point).norm() - truth.distance;
    const bool wrong = !(excess <= kWrong);
    ++result.queries;
    result.wrong += wrong ? 1 : 0;
    result.worst = std::max(result.worst, excess);
    result.below = std::max(result.below, -excess);
    result.certified += answer.certified ? 1 : 0;
    result.certifiedWrong += answer.certified && wrong ? 1 : 0;
}

std::vector<MethodResult> runMethods(const SearchWork& work,
                                     std::span<const GlobalReference::Nearest> truth,
                                     std::span<const std::unique_ptr<SearchMethod>> methods,
                                     int passes) {
    const double clock = clockCost();
    std::vector<Course> courses;
    courses.reserve(methods.size());
    for (const auto& method : methods) {
        courses.push_back(courseOf(*method, work.centers.size()));
    }
    for (int i = 0; i < passes; ++i) {
        for (Course& course : courses) {
            passInBlocks(work, truth.front().position, course);
            pass(work, truth.front().position, clock, course);
        }
    }
    std::vector<MethodResult> results;
    results.reserve(courses.size());
    for (const Course& course : courses) {
        results.push_back(resultOf(work, truth, course));
    }
    return results;
}

std::vector<MethodTimes> timeTasks(std::span<const MethodTask> tasks, int passes) {
    const double clock = clockCost();
    std::vector<Course> courses;
    courses.reserve(tasks.size());
    for (const MethodTask& task : tasks) {
        courses.push_back(courseOf(*task.method, task.work.centers.size()));
    }
    for (int i = 0; i < passes; ++i) {
        for (std::size_t task = 0; task < tasks.size(); ++task) {
            const SearchWork& work = tasks[task].work;
            pass(work, work.centers.front().head<2>(), clock, courses[task]);
        }
    }
    std::vector<MethodTimes> results;
    results.reserve(courses.size());
    for (const Course& course : courses) {
        const auto certified = std::ranges::count_if(course.answers, &SearchAnswer::certified);
        results.push_back({.time = summaryOf(course.times),
                           .queries = course.answers.size(),
                           .certified = static_cast<std::size_t>(certified)});
    }
    return results;
}

}  // namespace asperity
