// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/ThreadPool.h>

#include <osgTreeWind/base/Guarded.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <thread>
#include <vector>

namespace osgTreeWind {

namespace {

constexpr long maxThreads = 256;

unsigned wantedThreads() {
    if (const char* wanted = std::getenv("OSGTREEWIND_THREADS")) {
        const long number = std::strtol(wanted, nullptr, 10);
        if (number >= 1 && number <= maxThreads)
            return static_cast<unsigned>(number);
    }
    const unsigned processors = std::thread::hardware_concurrency();
    return processors > 0 ? processors : 1;
}

} // namespace

/// What one call of run() brings.
struct ThreadPool::Batch {
    const std::function<void(std::size_t)>& job;
    const std::size_t count;
    std::atomic<std::size_t> next{0};
    std::size_t helpers = 0; // threads of the pool at work on it; guarded by State::mutex
    std::condition_variable left;

    Batch(const std::function<void(std::size_t)>& job, std::size_t count) : job(job), count(count) {}
    void share() {
        for (std::size_t i = next++; i < count; i = next++)
            job(i);
    }
};

struct ThreadPool::State {
    std::mutex mutex;
    std::condition_variable brought;
    std::vector<Batch*> batches; // guarded by `mutex`, as is what follows
    bool ending = false;
    std::vector<std::thread> threads;

    Batch* open() const {
        for (Batch* batch : batches)
            if (batch->next < batch->count)
                return batch;
        return nullptr;
    }

    void help() {
        std::unique_lock<std::mutex> lock(mutex);
        for (;;) {
            Batch* batch = nullptr;
            brought.wait(lock, [&] { return ending || (batch = open()); });
            if (ending)
                return;
            ++batch->helpers;
            lock.unlock();
            batch->share();
            lock.lock();
            if (--batch->helpers == 0)
                batch->left.notify_one();
        }
    }
};

ThreadPool::ThreadPool(unsigned threads) : _state(new State) {
    const unsigned wanted = threads > 0 ? threads : wantedThreads();
    _state->threads.reserve(wanted - 1);
    bool comes = true; // else the system has no more of them
    for (unsigned i = 1; i < wanted && comes; ++i)
        runCatching([&] { _state->threads.emplace_back([state = _state.get()] { state->help(); }); },
                    [&] { comes = false; });
}

ThreadPool::~ThreadPool() {
    {
        const std::lock_guard<std::mutex> lock(_state->mutex);
        _state->ending = true;
    }
    _state->brought.notify_all();
    for (std::thread& thread : _state->threads)
        thread.join();
}

unsigned ThreadPool::threadCount() const {
    return static_cast<unsigned>(_state->threads.size()) + 1;
}

void ThreadPool::run(std::size_t count, const std::function<void(std::size_t)>& job) {
    if (_state->threads.empty() || count < 2)
        return runInTurn(count, job);
    Batch batch(job, count);
    {
        const std::lock_guard<std::mutex> lock(_state->mutex);
        _state->batches.push_back(&batch);
    }
    for (std::size_t i = 0; i < std::min(count - 1, _state->threads.size()); ++i)
        _state->brought.notify_one();
    batch.share();
    std::unique_lock<std::mutex> lock(_state->mutex);
    std::vector<Batch*>& batches = _state->batches;
    batches.erase(std::find(batches.begin(), batches.end(), &batch));
    batch.left.wait(lock, [&] { return batch.helpers == 0; });
}

Executor ThreadPool::executor(unsigned threads) {
    using Job = std::function<void(std::size_t)>;
    if (threads > 0)
        return [pool = std::make_shared<ThreadPool>(threads)](std::size_t count, const Job& job) {
            pool->run(count, job);
        };
    static ThreadPool ofTheProcess;
    return [](std::size_t count, const Job& job) { ofTheProcess.run(count, job); };
}

} // namespace osgTreeWind
