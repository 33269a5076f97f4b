// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/ThreadPool.h>

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

struct ThreadPool::State {
    std::mutex mutex;
    std::condition_variable begun, done;
    const std::function<void(std::size_t)>* job = nullptr; // what follows is guarded by `mutex`
    std::size_t count = 0, round = 0, working = 0;
    bool ending = false;
    std::atomic<std::size_t> next{0};
    std::vector<std::thread> threads;

    void share() {
        for (std::size_t i = next++; i < count; i = next++)
            (*job)(i);
    }

    void wait() {
        for (std::size_t seen = 0;;) {
            std::unique_lock<std::mutex> lock(mutex);
            begun.wait(lock, [&] { return ending || round != seen; });
            if (ending)
                return;
            seen = round;
            lock.unlock();
            share();
            lock.lock();
            if (--working == 0)
                done.notify_one();
        }
    }
};

ThreadPool::ThreadPool(unsigned threads) : _state(new State) {
    const unsigned wanted = threads > 0 ? threads : wantedThreads();
    for (unsigned i = 1; i < wanted; ++i)
        _state->threads.emplace_back([state = _state.get()] { state->wait(); });
}

ThreadPool::~ThreadPool() {
    {
        const std::lock_guard<std::mutex> lock(_state->mutex);
        _state->ending = true;
    }
    _state->begun.notify_all();
    for (std::thread& thread : _state->threads)
        thread.join();
}

unsigned ThreadPool::threadCount() const {
    return static_cast<unsigned>(_state->threads.size()) + 1;
}

void ThreadPool::run(std::size_t count, const std::function<void(std::size_t)>& job) {
    if (_state->threads.empty() || count < 2)
        return runInTurn(count, job);
    {
        const std::lock_guard<std::mutex> lock(_state->mutex);
        _state->job = &job;
        _state->count = count;
        _state->next = 0;
        _state->working = _state->threads.size();
        ++_state->round;
    }
    _state->begun.notify_all();
    _state->share();
    std::unique_lock<std::mutex> lock(_state->mutex);
    _state->done.wait(lock, [&] { return _state->working == 0; });
}

Executor ThreadPool::executor(unsigned threads) {
    return [pool = std::make_shared<ThreadPool>(threads)](
               std::size_t count, const std::function<void(std::size_t)>& job) { pool->run(count, job); };
}

} // namespace osgTreeWind
