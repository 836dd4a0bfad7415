#pragma once

#include <QDialog>
#include <QString>
#include <QStringList>

#include <vector>

namespace asperity {

class PixelView;

/// A library that the program is built with.
struct LibraryFact {
    QString name;
    QString version;
    QString license;      ///< its name: "BSD-3-Clause"
    QString licenseFile;  ///< where its text is
};

/// Parts that the program is made of, and the system it runs on.
struct ProgramFacts {
    QString version;   ///< of Asperity, with the commit
    QString compiler;  ///< with its version
    QString license;   ///< the text of Asperity's own
    std::vector<LibraryFact> libraries;
    QStringList system;  ///< a line each
};

/// What the program is for; on request the versions and licenses of it and of all that it is built
/// with, and a button that copies what a bug report should say.
class AboutBox : public QDialog {
    Q_OBJECT

public:
    AboutBox(const ProgramFacts& facts, QWidget* parent);

private:
    [[nodiscard]] QWidget* versions(const ProgramFacts& facts);
    [[nodiscard]] QWidget* licenses(const ProgramFacts& facts);
};

/// Returns the facts on program and machine for a bug report: plain text, a line each.
[[nodiscard]] QString reportText(const ProgramFacts& facts);

/// Returns the same of the machine, a line each: system, processor, screens, OpenGL.
/// @param view that draws with OpenGL; it may not have begun to
[[nodiscard]] QStringList systemFacts(const PixelView& view);

}  // namespace asperity
