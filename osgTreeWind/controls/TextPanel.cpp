// SPDX-License-Identifier: MIT
#include <osgTreeWind/controls/TextPanel.h>

#include <osgTreeWind/system/Path.h>
#include <osgTreeWind/system/Program.h>

#include <osg/Depth>
#include <osg/Fog>
#include <osgText/Font>

#include <algorithm>
#include <filesystem>

namespace osgTreeWind {

namespace {

constexpr float linesPerScreen = 48.0f, minCharacterSize = 12.0f; // pixels

/// That of the system if there is one, else OSG's built-in font, which is small and not monospace.
osg::ref_ptr<osgText::Font> monospaceFont() {
    const std::string file = monospaceFontFile();
    std::error_code error;
    osg::ref_ptr<osgText::Font> font =
        std::filesystem::exists(toPath(file), error) ? osgText::readRefFontFile(file) : nullptr;
    return font ? font : osgText::Font::getDefaultFont();
}

osg::ref_ptr<osgText::Text> makeText(osgText::Font* font) {
    osg::ref_ptr<osgText::Text> text = new osgText::Text;
    text->setDataVariance(osg::Object::DYNAMIC);
    text->setFont(font);
    text->setColor(osg::Vec4(1.0f, 1.0f, 1.0f, 1.0f));
    text->setDrawMode(osgText::TextBase::TEXT | osgText::TextBase::FILLEDBOUNDINGBOX);
    text->setBoundingBoxColor(osg::Vec4(0.0f, 0.0f, 0.0f, 0.55f));
    return text;
}

} // namespace

TextPanel::TextPanel() : _camera(new osg::Camera) {
    _camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    _camera->setViewMatrix(osg::Matrix::identity());
    _camera->setRenderOrder(osg::Camera::POST_RENDER, 100);
    _camera->setClearMask(0);
    _camera->setAllowEventFocus(false);
    _camera->setCullingActive(false);
    osg::StateSet* state = _camera->getOrCreateStateSet();
    state->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    state->setMode(GL_FOG, osg::StateAttribute::OFF);
    state->setMode(GL_BLEND, osg::StateAttribute::ON);
    state->setAttributeAndModes(new osg::Depth(osg::Depth::ALWAYS, 0.0, 1.0, false));
    const osg::ref_ptr<osgText::Font> font = monospaceFont();
    _corner = makeText(font);
    _corner->setAlignment(osgText::TextBase::LEFT_BOTTOM);
    _middle = makeText(font);
    _middle->setAlignment(osgText::TextBase::LEFT_CENTER);
    setSize(1280, 720);
}

void TextPanel::setSize(int width, int height) {
    if (_size == osg::Vec2(static_cast<float>(width), static_cast<float>(height)))
        return; // a change would rebuild the glyphs
    const float size = std::max(static_cast<float>(height) / linesPerScreen, minCharacterSize);
    _size.set(static_cast<float>(width), static_cast<float>(height));
    _camera->setProjectionMatrixAsOrtho2D(0.0, width, 0.0, height);
    for (osgText::Text* text : {_corner.get(), _middle.get()}) {
        text->setCharacterSize(size);
        text->setBoundingBoxMargin(0.5f * size);
        text->setFontResolution(static_cast<unsigned>(size), static_cast<unsigned>(size));
    }
    _corner->setPosition(osg::Vec3(size, size, 0.0f));
}

void TextPanel::show(const std::string& corner, const std::string& middle) {
    const auto set = [this](osgText::Text* text, const std::string& words) {
        text->setText(words, osgText::String::ENCODING_UTF8);
        if (words.empty())
            _camera->removeChild(text);
        else if (!_camera->containsNode(text))
            _camera->addChild(text);
    };
    set(_corner, corner);
    set(_middle, middle);
    const float width = _middle->getBoundingBox().xMax() - _middle->getBoundingBox().xMin();
    _middle->setPosition(osg::Vec3(std::max(0.5f * (_size.x() - width), 0.0f), 0.5f * _size.y(), 0.0f));
}

} // namespace osgTreeWind
