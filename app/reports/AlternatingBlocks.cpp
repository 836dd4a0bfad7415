#include "app/reports/AlternatingBlocks.h"

#include <algorithm>

namespace asperity {

namespace {

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

struct AlternatingBlocks::BareLoop {
    explicit BareLoop(double rate)
        : thread(std::in_place, rate, [this](const Beat& beat) {
            lateness.add(beat.lateness);
            skipped += beat.skipped;
        }) {}

    LatencyHistogram lateness;
    long skipped = 0;
    std::optional<PacedThread> thread;
};

AlternatingBlocks::AlternatingBlocks(HapticLoop& loop, double rate) : loop_(loop), rate_(rate) {
    beginOwn();
}

AlternatingBlocks::~AlternatingBlocks() { loop_.stop(); }

bool AlternatingBlocks::blockIsOver() const { return monotonicSeconds() - blockBegin_ >= kBlock; }

void AlternatingBlocks::beginOwn() {
    loop_.start();
    blockBegin_ = monotonicSeconds();
}

void AlternatingBlocks::beginBare() {
    running_ = std::make_unique<BareLoop>(rate_);
    blockBegin_ = monotonicSeconds();
}

void AlternatingBlocks::endOwn() {
    loop_.stop();
    ownP99_.push_back(loop_.times().lateness.quantile(0.99));
    own_.tick.add(loop_.times().tick);
    own_.lateness.add(loop_.times().lateness);
}

void AlternatingBlocks::endBare() {
    running_->thread.reset();
    bareP99_.push_back(running_->lateness.quantile(0.99));
    bare_.add(running_->lateness);
    bareSkipped_ += running_->skipped;
    running_.reset();
}

void AlternatingBlocks::poll() {
    if (!blockIsOver()) {
        return;
    }
    if (running_) {
        endBare();
        beginOwn();
    } else {
        endOwn();
        beginBare();
    }
}

void AlternatingBlocks::finish() {
    loop_.stop();
    running_.reset();
    ownP99_.resize(bareP99_.size());
}

double AlternatingBlocks::medianP99Ratio() const {
    return pairs() == 0
               ? 0.0
               : median({ownP99_.begin(), ownP99_.begin() + static_cast<std::ptrdiff_t>(pairs())}) /
                     median(bareP99_);
}

}  // namespace asperity
