// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/output/CommandError.h>
#include <examples/osgtreewind/pictures/OffscreenViewer.h>
#include <examples/osgtreewind/pictures/SrgbTables.h>
#include <examples/osgtreewind/portraits/PortraitSheet.h>
#include <examples/osgtreewind/scene/Setting.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/nodes/Forest.h>
#include <osgTreeWind/species/GrowthLaws.h>
#include <osgTreeWind/species/SizeLaws.h>

#include <glm/common.hpp>

#include <osg/Math>
#include <osgText/Font>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>

const char* const portraitLayout =
    "Rows of the sheet, each from left to right:\n"
    "  summer: bark at 3 m, leaves at 3 m, the tree with the sun behind the camera, against the sun, its "
    "outline\n"
    "  winter: the same\n"
    "  three shapes at 10, 50 and 200 m (with levels of detail), the tree in --season and in autumn\n"
    "From --panel 128 on, each picture has a label.";

namespace {

using namespace osgTreeWind;

constexpr int glyphWidth = 8, glyphHeight = 12; // of OSG's built-in font

/// Coverage of a letter, bottom row first; null for a space.
const osgText::Glyph* glyphOf(char letter) {
    const osgText::FontResolution resolution(glyphWidth, glyphHeight);
    const auto font = osgText::Font::getDefaultFont();
    return letter == ' ' ? nullptr : font->getGlyph(resolution, static_cast<unsigned char>(letter));
}

/// Blends a pixel with a grey. @param share weight of the grey, 0 to 255.
void mixGrey(unsigned char* pixel, int grey, int share) {
    for (int channel = 0; channel < 3; ++channel)
        pixel[channel] = static_cast<unsigned char>((grey * share + pixel[channel] * (255 - share)) / 255);
}

/// Writes a line of ASCII into the upper left corner of an 8-bit RGB or RGBA picture, white on a dark strip.
/// Writes nothing if the text does not fit.
void writeLabel(osg::Image& picture, const std::string& text) {
    const int scale = std::max(picture.s() / 192, 1), margin = 2 * scale;
    const int width = scale * glyphWidth * static_cast<int>(text.size()) + 2 * margin,
              height = scale * glyphHeight + 2 * margin;
    if (width > picture.s() || height > picture.t())
        return;
    const auto pixel = [&](int x, int y) { return picture.data(x, picture.t() - height + y); };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            mixGrey(pixel(x, y), 0, 150);
    int left = margin;
    for (const char letter : text) {
        if (const osgText::Glyph* glyph = glyphOf(letter))
            for (int y = 0; y < scale * glyph->t(); ++y)
                for (int x = 0; x < scale * glyph->s(); ++x)
                    if (y < height - margin && left + x < width)
                        mixGrey(pixel(left + x, margin + y), 255, *glyph->data(x / scale, y / scale));
        left += scale * glyphWidth;
    }
}

constexpr int sheetColumns = 5, sheetRows = 3, panelSamplesAcross = 3;

/// Size of a tree of usual height in a forest, by the laws of the species; empty for a species without laws.
TreeSize forestSize(Species species) {
    species.height.spread = species.crown.spread = 0.0f;
    return usualHeight(species) > 0.0f && species.height.scale > 0.0f
               ? estimateSize({usualHeight(species), 0.0f, 0.0f}, species, false, "").size
               : TreeSize{};
}

/// Trees of different shapes side by side across the view; the first stands at the origin.
osg::ref_ptr<Forest> row(const Species& species, bool openGrown, int trees, bool tiers) {
    ForestDescription forest;
    forest.species = {species};
    forest.species[0].shapes = std::max(species.shapes, trees);
    const double apart = 1.25 * static_cast<double>(measureTree(makeTreeModel(species.tree)).crownWidth);
    for (int i = 0; i < trees; ++i) {
        TreePlacement tree;
        const int pair = (i + 1) / 2;
        const double place = apart * pair * (i % 2 ? 1.0 : -1.0);
        tree.position = {0.74 * place, 0.67 * place, 0.0};
        tree.seed = static_cast<std::uint32_t>(i);
        tree.openGrown = openGrown;
        if (!openGrown)
            tree.size = forestSize(species);
        forest.trees.push_back(tree);
    }
    forest.drawing.tiers = tiers;
    return new Forest(std::move(forest));
}

class Sheet {
public:
    Sheet(const Species& species, bool openGrown, int panel)
        : _growingPlace(openGrown ? "open" : "forest"), _drawing(panel, panel, panelSamplesAcross),
          _tree(row(species, openGrown, 1, false)), _trees(row(species, openGrown, 3, true)),
          _treeSetting(createSetting(*_tree)), _treesSetting(createSetting(*_trees)), _image(new osg::Image) {
        const PlacedTree& tree = movingForest(_tree->getSimulation()).trees().front();
        _size = movingForest(_tree->getSimulation()).placed().sizeOf(tree);
        const auto& leaves = movingForest(_tree->getSimulation()).models().front()->leaves;
        for (const LeafCluster& leaf : leaves)
            _leaves +=
                osg::Vec3d(0, 0, tree.scale.axes.z * leaf.anchor.z) / static_cast<double>(leaves.size());
        _image->allocateImage(sheetColumns * panel, sheetRows * panel, 1, GL_RGB, GL_UNSIGNED_BYTE);
    }

    osg::ref_ptr<osg::Image> draw(float season) {
        _drawing.viewer().getCamera()->setProjectionMatrixAsPerspective(fieldOfView, 1.0, 0.5, 10000.0);
        drawSeason("summer", midsummer, 0);
        drawSeason("winter", midwinter, 1);
        drawFromAfar(10, 0);
        drawFromAfar(50, 1);
        drawFromAfar(200, 2);
        throwIfAny(_tree->setSeason(season));
        whole(frontLit, nameOf(season), 3, 2);
        throwIfAny(_tree->setSeason(midautumn));
        whole(frontLit, "autumn", 4, 2);
        return _image;
    }

private:
    static constexpr double fieldOfView = 36.0;
    /// Of outlines: a pixel is dark, below 128 of 255, if at least 0.6 of it is covered, as in TreeLooks.cpp.
    static constexpr float outlineGamma = 0.756f;
    /// Directions to a camera that has the sun at its side and behind it, and to one that faces the sun.
    static inline const osg::Vec3d frontLit{0.36, -0.93, 0.0};
    static inline const osg::Vec3d backLit{-0.67, 0.74, 0.0};

    static std::string nameOf(float season) {
        std::ostringstream number;
        number << "season " << std::setprecision(3) << season;
        return season == midspring ? "spring" : number.str();
    }

    void drawSeason(const std::string& name, float season, int row) {
        throwIfAny(_tree->setSeason(season));
        look(_treeSetting, frontLit * (3.0 + 0.5 * static_cast<double>(_size.trunkDiameter)) + up(1.6),
             up(1.9));
        put(shot(), "bark, " + name, 0, row);
        const osg::Vec3d edge = frontLit * (0.5 * static_cast<double>(_size.crownWidth));
        look(_treeSetting, edge + frontLit * 3.0 + _leaves - up(1.0), edge * 0.8 + _leaves);
        put(shot(), "leaves, " + name, 1, row);
        whole(frontLit, name + ", " + _growingPlace, 2, row);
        whole(backLit, "against the sun", 3, row);
        silhouette(name, row);
    }

    void drawFromAfar(int metres, int column) {
        const double distance = metres;
        const double rise = std::min(0.45 * static_cast<double>(_size.height), 1.6 + 0.22 * distance);
        look(_treesSetting, frontLit * distance + up(1.6), up(rise));
        put(shot(), "at " + std::to_string(metres) + " m", column, 2);
    }

    void whole(const osg::Vec3d& toEye, const std::string& label, int column, int row) {
        lookAtWhole(_treeSetting, toEye);
        put(shot(), label, column, row);
    }

    /// The sky's share of each pixel is the difference of a picture on white and one on black, in linear
    /// light.
    void silhouette(const std::string& name, int row) {
        lookAtWhole(_tree, frontLit);
        osg::ref_ptr<osg::Image> white, black;
        for (osg::ref_ptr<osg::Image>* image : {&white, &black}) {
            const float grey = image == &white ? 1.0f : 0.0f;
            const osg::Vec4 former = _drawing.viewer().getCamera()->getClearColor();
            _drawing.viewer().getCamera()->setClearColor(osg::Vec4(grey, grey, grey, 1.0f));
            *image = new osg::Image(shot());
            _drawing.viewer().getCamera()->setClearColor(former);
        }
        const auto& linear = srgbTables().linear;
        for (unsigned i = 0; i < white->getTotalSizeInBytes(); ++i) {
            const float sky = glm::clamp(linear[white->data()[i]] - linear[black->data()[i]], 0.0f, 1.0f);
            white->data()[i] = static_cast<unsigned char>(std::lround(255.0f * math::pow(sky, outlineGamma)));
        }
        put(*white, "outline, " + name, 4, row);
    }

    static osg::Vec3d up(double metres) { return {0.0, 0.0, metres}; }

    void lookAtWhole(osg::Node* scene, const osg::Vec3d& toEye) {
        const double height = _size.height, size = std::max(height, static_cast<double>(_size.crownWidth));
        const double distance = 0.51 * size / math::tan(osg::DegreesToRadians(0.5 * fieldOfView));
        look(scene, toEye * (distance + 0.25 * static_cast<double>(_size.crownWidth)) + up(1.6),
             up(0.47 * height));
    }

    void look(osg::Node* scene, const osg::Vec3d& eye, const osg::Vec3d& center) {
        if (_drawing.viewer().getSceneData() != scene)
            _drawing.viewer().setSceneData(scene);
        _drawing.viewer().getCamera()->setViewMatrixAsLookAt(eye, center, osg::Z_AXIS);
    }

    osg::Image& shot() {
        _drawing.frame(0.0); // what is seen for the first time appears in the next frame
        return _drawing.frame(0.0);
    }

    void put(osg::Image& panel, const std::string& label, int column, int row) {
        writeLabel(panel, label);
        for (int y = 0; y < panel.t(); ++y)
            for (int x = 0; x < panel.s(); ++x)
                std::copy_n(panel.data(static_cast<unsigned>(x), static_cast<unsigned>(y)), 3,
                            _image->data(static_cast<unsigned>(column * panel.s() + x),
                                         static_cast<unsigned>((sheetRows - 1 - row) * panel.t() + y)));
    }

    std::string _growingPlace;
    OffscreenViewer _drawing;
    osg::ref_ptr<Forest> _tree, _trees;
    osg::ref_ptr<osg::Group> _treeSetting, _treesSetting;
    osg::ref_ptr<osg::Image> _image;
    TreeSize _size;
    osg::Vec3d _leaves; ///< Mean position of the leaves.
};

} // namespace

osg::ref_ptr<osg::Image> drawPortrait(const Species& species, bool openGrown, int panel, float season) {
    return Sheet(species, openGrown, panel).draw(season);
}
