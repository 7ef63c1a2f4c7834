//! Elements of a model. The tree contains the elements of all included files.

use roxmltree::Node;

/// Index of an element in its [`ElementTree`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct ElementId(pub(crate) u32);

/// XML element with its position.
#[derive(Debug)]
pub(crate) struct Element {
    pub tag: String,
    pub attributes: Vec<Attribute>,
    pub children: Vec<ElementId>,
    /// Text of the element without comments and surrounding white space; empty in formats whose values are attributes.
    pub text: String,
    pub parent: Option<ElementId>,
    /// Index of the file in [`ElementTree::files`].
    pub file: usize,
    /// Byte offset in the file.
    pub offset: usize,
}

impl Element {
    /// Element without attributes, children and text.
    pub fn empty(tag: String, parent: Option<ElementId>, file: usize, offset: usize) -> Self {
        let (attributes, children, text) = (Vec::new(), Vec::new(), String::new());
        Self { tag, attributes, children, text, parent, file, offset }
    }

    /// Element of a file, without children and text; `is_read`: true for the attributes that are kept.
    pub fn new(
        node: Node<'_, '_>,
        file: usize,
        parent: Option<ElementId>,
        is_read: impl Fn(&roxmltree::Attribute<'_, '_>) -> bool,
    ) -> Self {
        let attributes = node.attributes().filter(is_read).map(|attribute| Attribute {
            name: attribute.name().to_owned(),
            value: attribute.value().to_owned(),
            offset: attribute.range().start,
        });
        let tag = node.tag_name().name().to_owned();
        Self { attributes: attributes.collect(), ..Self::empty(tag, parent, file, node.range().start) }
    }
}

/// Attribute with its position.
#[derive(Debug)]
pub(crate) struct Attribute {
    pub name: String,
    pub value: String,
    /// Byte offset in the file of the element.
    pub offset: usize,
}

/// File that was read.
#[derive(Debug)]
pub(crate) struct FileText {
    /// Path, as the user or the `<include>` gave it.
    pub name: String,
    pub text: String,
    /// Index of the model to which the file belongs: 0 for the main model, further numbers for attached models of MJCF.
    pub model: usize,
}

/// All elements of a model; the first element is the root of the main file.
#[derive(Debug, Default)]
pub(crate) struct ElementTree {
    pub elements: Vec<Element>,
    /// The main file, then the included files.
    pub files: Vec<FileText>,
}

impl ElementTree {
    /// Root element of the main file.
    pub fn root(&self) -> ElementId {
        ElementId(0)
    }

    /// Appends an element, also to the children of its parent.
    pub fn append(&mut self, element: Element) -> ElementId {
        let id = ElementId(self.elements.len() as u32);
        if let Some(parent) = element.parent {
            self.elements[parent.0 as usize].children.push(id);
        }
        self.elements.push(element);
        id
    }

    /// The element with this index.
    pub fn element(&self, id: ElementId) -> &Element {
        &self.elements[id.0 as usize]
    }

    /// Tag of an element.
    pub fn tag(&self, id: ElementId) -> &str {
        &self.element(id).tag
    }

    /// Child elements.
    pub fn children(&self, id: ElementId) -> &[ElementId] {
        &self.element(id).children
    }

    /// Child elements with a tag.
    pub fn children_named<'t>(&'t self, id: ElementId, tag: &'t str) -> impl Iterator<Item = ElementId> + 't {
        self.children(id).iter().copied().filter(move |child| self.tag(*child) == tag)
    }

    /// First child element with a tag.
    pub fn child(&self, id: ElementId, tag: &str) -> Option<ElementId> {
        self.children(id).iter().copied().find(|child| self.tag(*child) == tag)
    }

    /// Text of an element, without white space at its ends.
    pub fn text(&self, id: ElementId) -> &str {
        &self.element(id).text
    }

    /// Children of all sections with a tag, in the order of the file: sections may occur several times.
    pub fn in_sections<'t>(&'t self, tag: &'t str) -> impl Iterator<Item = ElementId> + 't {
        self.children_named(self.root(), tag).flat_map(|section| self.children(section).iter().copied())
    }

    /// As [`in_sections`](Self::in_sections), below another root.
    pub fn in_sections_of<'t>(
        &'t self,
        root: ElementId,
        tag: &'t str,
    ) -> impl Iterator<Item = ElementId> + 't {
        self.children_named(root, tag).flat_map(|section| self.children(section).iter().copied())
    }

    /// Index of the model whose file contains an element.
    pub fn model_of(&self, id: ElementId) -> usize {
        self.files[self.element(id).file].model
    }

    /// Value of an attribute of the element itself.
    pub fn attribute(&self, id: ElementId, name: &str) -> Option<&str> {
        self.element(id).attributes.iter().find(|a| a.name == name).map(|a| a.value.as_str())
    }

    /// Byte offset of an attribute; that of the element if the attribute is absent.
    pub fn attribute_offset(&self, id: ElementId, name: &str) -> usize {
        let element = self.element(id);
        element.attributes.iter().find(|a| a.name == name).map_or(element.offset, |a| a.offset)
    }
}
