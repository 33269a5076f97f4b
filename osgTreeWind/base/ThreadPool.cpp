// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/ThreadPool.h>

#include <osgTreeWind/base/Guarded.h>
#include <osgTreeWind/system/Program.h>

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

unsigned defaultThreadCount() {
    if (const auto wanted = environmentVariable("OSGTREEWIND_THREADS")) {
        const long number = std::strtol(wanted->c_str(), nullptr, 10);
        if (number >= 1 && number <= maxThreads)
            return static_cast<unsigned>(number);
    }
    const unsigned processors = std::thread::hardware_concurrency();
    return processors > 0 ? processors : 1;
}

/// A pool until the end of the process.
class ProcessPool {
public:
    ProcessPool() = default;
    ~ProcessPool() {
        if (!_endsThreadsFirst)
            delete _pool;
    }
    ProcessPool(const ProcessPool&) = delete;
    ProcessPool& operator=(const ProcessPool&) = delete;
    ThreadPool& get() const { return *_pool; }

private:
    const bool _endsThreadsFirst = endsThreadsFirst();
    ThreadPool* _pool = new ThreadPool;
};

} // namespace

/// The jobs of one call of run().
struct ThreadPool::Batch {
    const std::function<void(std::size_t)>& job;
    const std::size_t count;
    std::atomic<std::size_t> next{0};
    std::size_t helpers = 0; // workers in runRemaining(); guarded by State::mutex
    std::condition_variable helpersLeft;

    Batch(const std::function<void(std::size_t)>& job, std::size_t count) : job(job), count(count) {}
    void runRemaining() {
        for (std::size_t i = next++; i < count; i = next++)
            job(i);
    }
};

struct ThreadPool::State {
    std::mutex mutex;
    std::condition_variable batchAdded;
    std::vector<Batch*> batches; // guarded by `mutex`
    bool isStopping = false;     // guarded by `mutex`
    std::vector<std::thread> threads;

    Batch* findOpenBatch() const {
        for (Batch* batch : batches)
            if (batch->next < batch->count)
                return batch;
        return nullptr;
    }

    void runWorker() {
        std::unique_lock<std::mutex> lock(mutex);
        for (;;) {
            Batch* batch = nullptr;
            batchAdded.wait(lock, [&] { return isStopping || (batch = findOpenBatch()); });
            if (isStopping)
                return;
            ++batch->helpers;
            lock.unlock();
            batch->runRemaining();
            lock.lock();
            if (--batch->helpers == 0)
                batch->helpersLeft.notify_one();
        }
    }
};

ThreadPool::ThreadPool(unsigned threads) : _state(new State) {
    const unsigned wanted = threads > 0 ? threads : defaultThreadCount();
    _state->threads.reserve(wanted - 1);
    bool hasStarted = true; // false: the system's thread limit is reached
    for (unsigned i = 1; i < wanted && hasStarted; ++i)
        runCatching([&] { _state->threads.emplace_back([state = _state.get()] { state->runWorker(); }); },
                    [&] { hasStarted = false; });
}

ThreadPool::~ThreadPool() {
    {
        const std::lock_guard<std::mutex> lock(_state->mutex);
        _state->isStopping = true;
    }
    _state->batchAdded.notify_all();
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
        _state->batchAdded.notify_one();
    batch.runRemaining();
    std::unique_lock<std::mutex> lock(_state->mutex);
    std::vector<Batch*>& batches = _state->batches;
    batches.erase(std::find(batches.begin(), batches.end(), &batch));
    batch.helpersLeft.wait(lock, [&] { return batch.helpers == 0; });
}

Executor ThreadPool::executor(unsigned threads) {
    using Job = std::function<void(std::size_t)>;
    if (threads > 0)
        return [pool = std::make_shared<ThreadPool>(threads)](std::size_t count, const Job& job) {
            pool->run(count, job);
        };
    static ProcessPool processPool;
    return [](std::size_t count, const Job& job) { processPool.get().run(count, job); };
}

} // namespace osgTreeWind
