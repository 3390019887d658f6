// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewer/viewer_window.h"

#include "core/base/input_error.h"
#include "ui/common/file_dialog.h"
#include "ui/common/wheel_guard.h"
#include "ui/viewer/chart_export.h"
#include "ui/viewer/column_list.h"
#include "ui/viewer/cursor_table.h"
#include "ui/viewer/log_summary.h"
#include "ui/viewer/problem_panel.h"
#include "ui/viewer/view_bar.h"

#include <QDragEnterEvent>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QSaveFile>
#include <QStackedWidget>
#include <QTabBar>

namespace hexapose {

ViewerWindow::ViewerWindow(QWidget* parent)
    : QMainWindow(parent), m_bar(new ViewBar(this)), m_tabs(new QTabBar(this)),
      m_pages(new QStackedWidget(this)), m_hint(new QLabel(this)), m_summary(new LogSummary(this)),
      m_columns(new ColumnList(this)), m_problems(new ProblemPanel(this)),
      m_cursorTable(new CursorTable(this)), m_export(QStringLiteral("export")) {
    build();
    wire();
    setAcceptDrops(true);
    new WheelGuard(this);
    retranslate();
    showCurrent();
}

void ViewerWindow::wire() {
    connect(m_bar, &ViewBar::openRequested, this, [this] { askForLogs(false); });
    connect(m_bar, &ViewBar::exportRequested, this, [this] { askForExport(); });
    connect(m_tabs, &QTabBar::currentChanged, this, &ViewerWindow::showCurrent);
    connect(m_tabs, &QTabBar::tabCloseRequested, this, &ViewerWindow::closeLog);
    connect(m_summary, &LogSummary::cancelRequested, this, [this] {
        if (LogPage* page = current())
            page->file().cancel();
    });
    connect(m_columns, &ColumnList::addRequested, this, [this](const QStringList& names) {
        LogPage* page = current();
        for (const QString& name : names) {
            if (page == nullptr)
                break;
            if (page->sheet().chartCount() == 0)
                page->sheet().addChart({});
            page->sheet().addCurve(page->sheet().currentChart(), {name, {}});
        }
    });
    connect(m_columns, &ColumnList::newChartRequested, this, [this](const QStringList& names) {
        ChartSpec chart;
        for (const QString& name : names)
            chart.curves.push_back({name, {}});
        if (LogPage* page = current())
            page->sheet().addChart(chart);
    });
}

void ViewerWindow::setColors(ThemeKind theme) {
    m_theme = theme;
    m_cursorTable->setColors(theme);
    for (int i = 0; i < logCount(); ++i)
        static_cast<LogPage*>(m_pages->widget(i + 1))->sheet().setColors(themeColors(theme), theme);
}

int ViewerWindow::logCount() const {
    return m_tabs->count();
}

/// Behind the first page of the stack, which stands for no log.
LogPage* ViewerWindow::current() const {
    return qobject_cast<LogPage*>(m_pages->widget(m_tabs->currentIndex() + 1));
}

void ViewerWindow::openLogs(const QStringList& files, const FirstView& first) {
    for (const QString& file : files) {
        auto* page = new LogPage(QFileInfo(file).absoluteFilePath(), first, m_pages);
        page->sheet().setColors(themeColors(m_theme), m_theme);
        m_pages->addWidget(page);
        connect(page, &LogPage::changed, this, [this, page] {
            if (page == current())
                refresh();
        });
        connect(&page->sheet(), &ChartSheet::exportRequested, this,
                [this](const ChartSpec& chart) { askForExport(chart); });
        const int tab = m_tabs->addTab(page->file().name());
        m_tabs->setTabToolTip(tab, page->file().path());
        m_folder = QFileInfo(file).absolutePath();
        emit logOpened(page->file().path());
        m_tabs->setCurrentIndex(tab);
    }
    showCurrent();
}

void ViewerWindow::closeLog(int index) {
    QWidget* page = m_pages->widget(index + 1);
    if (page == current()) {
        m_bar->follow(nullptr);
        m_cursorTable->follow(nullptr);
    }
    m_pages->removeWidget(page);
    delete page;
    m_tabs->removeTab(index);
    showCurrent();
}

void ViewerWindow::closeCurrent() {
    if (current() != nullptr)
        closeLog(m_tabs->currentIndex());
}

void ViewerWindow::showCurrent() {
    if (m_tabs->count() != m_pages->count() - 1)
        return; // a tab without its page yet, or the other way round
    LogPage* page = current();
    m_tabs->setVisible(m_tabs->count() > 1);
    m_pages->setCurrentIndex(m_tabs->currentIndex() + 1);
    m_bar->follow(page != nullptr ? &page->sheet() : nullptr);
    m_cursorTable->follow(page != nullptr ? &page->sheet() : nullptr);
    m_cursorTable->setVisible(page != nullptr);
    refresh();
    emit currentChanged();
}

void ViewerWindow::refresh() {
    LogPage* page = current();
    if (page == nullptr) {
        m_summary->showNothing();
        m_columns->showTable(Table());
        m_problems->showProblems(std::make_shared<Table>(), {});
    } else {
        const std::shared_ptr<const Table>& table = page->sheet().table();
        m_summary->showLog(page->file().name(), *table, page->file().progress());
        m_columns->showTable(*table);
        m_problems->showProblems(table, page->file().path());
    }
    retranslate();
}

void ViewerWindow::askForLogs(bool inThisLayout) {
    FileQuestion question{inThisLayout ? tr("Open log in this layout") : tr("Open log")};
    question.filter = tr("Logs and tables (*.csv *.csv.gz *.tsv *.txt);;All files (*)");
    question.folder = m_folder;
    FirstView first;
    if (inThisLayout && current() != nullptr)
        first.layout = current()->sheet().chartLayout();
    askForFiles(*this, question, [this, first](const QStringList& files) { openLogs(files, first); });
}

void ViewerWindow::askForExport(const std::optional<ChartSpec>& chart) {
    if (current() == nullptr)
        return;
    FileQuestion question{tr("Export")};
    question.filter = tr("PNG picture (*.png);;SVG drawing (*.svg);;PDF page (*.pdf);;"
                         "Rows shown, as they stand in the log (*.csv)");
    question.folder = m_folder;
    question.mode = QFileDialog::AnyFile;
    question.accept = QFileDialog::AcceptSave;
    question.suffix = QStringLiteral("png");
    askForFile(*this, question, [this, chart](const QString& file) { exportTo(file, chart); });
}

/// In the background: rows by the gigabyte take their time.
void ViewerWindow::exportTo(const QString& file, const std::optional<ChartSpec>& chart) {
    LogPage* page = current();
    if (page == nullptr)
        return;
    const ChartPicture picture{page->sheet().table(),
                               chart ? ChartLayout{{*chart}} : page->sheet().chartLayout(),
                               page->sheet().time(), QFile::encodeName(page->file().path()).toStdString()};
    m_bar->setExporting(true);
    m_export.start(
        [picture, to = QFile::encodeName(file).toStdString()](const Job& /*job*/) {
            exportCharts(picture, to);
            return true;
        },
        [this](const Job::Outcome<bool>& outcome) {
            m_bar->setExporting(false);
            if (!outcome.result)
                complain(outcome.error);
        });
}

void ViewerWindow::saveLayout() {
    if (current() == nullptr)
        return;
    FileQuestion question{tr("Save layout"),    tr("Layouts (*.json)"),  m_folder,
                          QFileDialog::AnyFile, QFileDialog::AcceptSave, QStringLiteral("json")};
    const QByteArray text = formatLayout(current()->sheet().chartLayout());
    askForFile(*this, question, [this, text](const QString& file) {
        QSaveFile out(file);
        if (!out.open(QIODevice::WriteOnly) || out.write(text) != text.size() || !out.commit())
            complain(tr("%1 cannot be written: %2").arg(file, out.errorString()));
    });
}

void ViewerWindow::loadLayoutFile() {
    if (current() == nullptr)
        return;
    const FileQuestion question{tr("Load layout"), tr("Layouts (*.json);;All files (*)"), m_folder};
    askForFile(*this, question, [this](const QString& file) {
        try {
            if (LogPage* page = current())
                page->sheet().setChartLayout(loadLayout(file));
        } catch (const InputError& error) {
            complain(QString::fromUtf8(error.what()));
        }
    });
}

void ViewerWindow::complain(const QString& what) {
    auto* box = new QMessageBox(QMessageBox::Warning, tr("Hexapose viewer"), what, QMessageBox::Close, this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

void ViewerWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls())
        event->acceptProposedAction();
}

void ViewerWindow::dropEvent(QDropEvent* event) {
    QStringList files;
    for (const QUrl& url : event->mimeData()->urls())
        if (url.isLocalFile())
            files.append(url.toLocalFile());
    openLogs(files);
    event->acceptProposedAction();
}

} // namespace hexapose

#include "moc_viewer_window.cpp"
