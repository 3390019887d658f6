// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/table/table_loader.h"

#include "core/base/input_error.h"
#include "core/table/line_blocks.h"
#include "core/table/row_parser.h"
#include "core/table/table_builder.h"
#include "core/table/text_source.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <new>
#include <thread>
#include <utility>
#include <vector>

namespace hexapose {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPublishEvery{50};
constexpr std::uint64_t kLargeFile = std::uint64_t{64} << 20;

} // namespace

struct TableLoader::Impl {
    Impl(std::filesystem::path theFile, Options theOptions)
        : file(std::move(theFile)), options(std::move(theOptions)), latest(std::make_shared<const Table>()) {}

    // The threads: one begins, and starts the others when the format is known.
    void run();
    void open();
    void parseBlocks();
    bool takeBlock(LineBlock& block, std::size_t& number);
    void append(const ParsedRows& rows, std::size_t number);
    void fail(const std::string& cause);
    void publish(bool isDone);

    std::filesystem::path file;
    Options options;
    std::atomic<bool> isCancelled{false};

    std::mutex reading; ///< guards what cuts the file into blocks
    std::unique_ptr<TextSource> source;
    std::unique_ptr<LineBlocks> blocks;
    std::optional<LineBlock> first; ///< the format was found out from it
    TableFormat format;
    std::size_t taken = 0; ///< blocks

    std::mutex building; ///< guards the builder
    std::condition_variable turn;
    std::unique_ptr<TableBuilder> builder;
    std::size_t begun = 0; ///< blocks
    bool hasFailed = false;

    mutable std::mutex publishing; ///< guards what others ask for
    std::shared_ptr<const Table> latest;
    LoadProgress progress;
    Clock::time_point published{};

    std::jthread thread; ///< last: it uses the rest
};

void TableLoader::Impl::open() {
    source = std::make_unique<TextSource>(file, [this] { return isCancelled.load(); });
    blocks = std::make_unique<LineBlocks>(
        *source, options.format && options.blockSize > 0 ? options.blockSize : LineBlocks::kBlock);
    {
        const std::lock_guard lock(publishing);
        progress.bytesInAll = source->size();
    }
    LineBlock block;
    const bool any =
        blocks->next(block, options.format ? options.format->separator : LineBlocks::kAnySeparator);
    if (any && block.skipped > 0)
        throw InputError(source->name(), "begins with a line of over " +
                                             std::to_string(LineBlocks::kLongestLine >> 20) +
                                             " MiB: not a table");
    const std::string_view text(block.text.data(), any ? block.size : 0);
    format = options.format ? *options.format : detectFormat(text, !any || block.isLast, source->name());
    builder = std::make_unique<TableBuilder>(format, source->name(), source->size() > kLargeFile);
    if (!any)
        return;
    // The block again, without what stands before its first row.
    const auto begin = block.text.begin() + static_cast<std::ptrdiff_t>(
                                                std::min<std::uint64_t>(format.firstRowOffset, block.size));
    block.text.erase(block.text.begin(), begin);
    block.offset += format.firstRowOffset;
    block.size -= static_cast<std::size_t>(std::min<std::uint64_t>(format.firstRowOffset, block.size));
    first = std::move(block);
}

void TableLoader::Impl::run() {
    try {
        open();
        publish(false);
        int count =
            options.threads > 0 ? options.threads : static_cast<int>(std::thread::hardware_concurrency());
        if (source->size() > 0 && source->size() < LineBlocks::kBlock)
            count = 1;
        {
            std::vector<std::jthread> others;
            for (int i = 1; i < count; ++i)
                others.emplace_back([this] { parseBlocks(); });
            parseBlocks();
        }
        if (source->hasShrunk() && !isCancelled) {
            const std::lock_guard lock(building);
            builder->report({Problem::Kind::FileChanged, 0, {}, {}});
        }
    } catch (const InputError& error) {
        fail(error.what());
    } catch (const std::bad_alloc&) {
        fail(file.string() + ": does not fit into memory");
    }
    publish(true);
}

void TableLoader::Impl::fail(const std::string& cause) {
    {
        const std::lock_guard lock(building);
        hasFailed = true;
    }
    turn.notify_all();
    const std::lock_guard lock(publishing);
    if (!progress.error)
        progress.error = cause;
}

bool TableLoader::Impl::takeBlock(LineBlock& block, std::size_t& number) {
    const std::lock_guard lock(reading);
    if (isCancelled)
        return false;
    if (first) {
        block = std::move(*first);
        first.reset();
    } else if (!blocks->next(block, format.separator)) {
        return false;
    }
    number = taken++;
    const std::lock_guard progressLock(publishing);
    progress.bytesRead = source->bytesRead();
    return true;
}

void TableLoader::Impl::parseBlocks() {
    try {
        RowParser parser(format);
        LineBlock block;
        for (std::size_t number = 0; takeBlock(block, number);)
            append(parser.parse(block), number);
    } catch (const InputError& error) {
        fail(error.what());
    } catch (const std::bad_alloc&) {
        fail(file.string() + ": does not fit into memory");
    }
}

void TableLoader::Impl::append(const ParsedRows& rows, std::size_t number) {
    TableBuilder::Reserved reserved;
    {
        std::unique_lock lock(building);
        turn.wait(lock, [&] { return begun == number || hasFailed; });
        if (hasFailed)
            return;
        reserved = builder->begin(rows);
        ++begun;
    }
    turn.notify_all();
    TableBuilder::copy(rows, reserved, format);
    {
        const std::lock_guard lock(building);
        builder->complete(std::move(reserved));
    }
    publish(false);
}

/// Makes what there is known, when it is time.
void TableLoader::Impl::publish(bool isDone) {
    {
        const std::lock_guard lock(publishing);
        const Clock::time_point now = Clock::now();
        if (!isDone && now - published < kPublishEvery)
            return;
        published = now;
    }
    std::shared_ptr<const Table> table;
    {
        const std::lock_guard lock(building);
        if (builder)
            table = builder->table();
    }
    {
        const std::lock_guard lock(publishing);
        if (table && table->rowCount() >= latest->rowCount())
            latest = table;
        progress.rows = latest->rowCount();
        progress.isDone = isDone;
        progress.isCancelled = isDone && isCancelled;
        if (source && isDone)
            progress.bytesRead = source->bytesRead();
    }
    if (options.onProgress)
        options.onProgress();
}

TableLoader::TableLoader(std::filesystem::path file, Options options)
    : m_impl(std::make_unique<Impl>(std::move(file), std::move(options))) {
    m_impl->thread = std::jthread([impl = m_impl.get()] { impl->run(); });
}

TableLoader::~TableLoader() {
    cancel();
    wait();
}

void TableLoader::cancel() {
    m_impl->isCancelled = true;
}

void TableLoader::wait() {
    if (m_impl->thread.joinable())
        m_impl->thread.join();
}

LoadProgress TableLoader::progress() const {
    const std::lock_guard lock(m_impl->publishing);
    return m_impl->progress;
}

std::shared_ptr<const Table> TableLoader::table() const {
    const std::lock_guard lock(m_impl->publishing);
    return m_impl->latest;
}

std::shared_ptr<const Table> loadTable(const std::filesystem::path& file,
                                       const std::optional<TableFormat>& format) {
    TableLoader loader(file, {format, 0, {}, 0});
    loader.wait();
    if (const auto error = loader.progress().error)
        throw InputError(*error);
    return loader.table();
}

} // namespace hexapose
