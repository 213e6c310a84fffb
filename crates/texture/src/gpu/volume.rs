//! [`TextureVolume`]: a silhouette texture on a device. Stages: `shaders/texture/lookup.wgsl` and `lookup.terms.wgsl`.

use super::near_plane::meets_hull;
use super::texture_vertices::TextureVertices;
use crate::hull::Hull;
use crate::silhouette_texture::{Angles, SilhouetteTexture, Terms};
use half::f16;
use silhouette_core::mesh::Bounds;
use silhouette_gpu::kit::{bind_group, bind_layout};
use silhouette_gpu::{FrameView, LocalFrame, RendererError};
use silhouette_rays::MeshHierarchy;
use std::fmt;
use std::ops::Range;
use wgpu::{TextureFormat, TextureViewDimension};

silhouette_core::option_choice! {
    /// In which form angles, or the weights of terms, lie on the device, and who filters them.
    ///
    /// Adapters need no more than 8 bits to filter 8-bit formats; Mesa's software adapter takes 8 and is off by up to 1.84 of 255
    /// steps, 1.3 degrees, where it blends all three coordinates.
    pub enum Filtering {
        /// As stored, filtered by the hardware.
        Native = "native",
        /// As 16-bit floats, filtered by the hardware: exact to a tenth of a step of 8 bits, for twice the memory.
        Float16 = "float16",
        /// As stored, filtered by the fragment stage in 32 bits: exact, with eight loads per angle.
        Manual = "manual",
    }
}

/// What pipelines must know of the volumes that they draw.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct VolumeForm {
    pub(super) has_terms: bool,
    pub(super) is_filtered: bool,
    pub(super) has_texel_centers: bool,
}

impl VolumeForm {
    /// The form that a texture takes.
    pub fn new(texture: &SilhouetteTexture, filtering: Filtering) -> Self {
        Self {
            has_terms: matches!(texture.parts().angles, Angles::Terms(_)),
            is_filtered: filtering != Filtering::Manual,
            has_texel_centers: texture.parts().texel_centers.is_some(),
        }
    }

    /// Bind group 2: what was baked on a page.
    pub(super) fn layout(self, device: &wgpu::Device) -> wgpu::BindGroupLayout {
        let entry = |binding, ty| wgpu::BindGroupLayoutEntry {
            binding,
            visibility: wgpu::ShaderStages::FRAGMENT,
            ty,
            count: None,
        };
        let texture = |binding, view_dimension, filterable| {
            let sample_type = wgpu::TextureSampleType::Float { filterable };
            entry(binding, wgpu::BindingType::Texture { sample_type, view_dimension, multisampled: false })
        };
        let flat = |binding| texture(binding, TextureViewDimension::D2, true);
        let mut entries = vec![
            entry(0, wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering)),
            flat(1),
            flat(2),
            flat(3),
            flat(4),
        ];
        if self.has_terms {
            entries
                .extend([texture(5, TextureViewDimension::D2Array, true), texture(6, TextureViewDimension::D2, false)]);
        } else {
            entries.push(texture(5, TextureViewDimension::D3, true));
        }
        bind_layout(device, "silhouette texture: page", &entries)
    }
}

/// A hull and all that was baked on it, on a device, shared by all instances of the object.
pub struct TextureVolume {
    form: VolumeForm,
    frame: LocalFrame,
    bounds: Option<Bounds>,
    radius: f64,
    azimuths: u32,
    bytes: u64,
    /// Vertices and triangles; `None` without triangles.
    buffers: Option<(wgpu::Buffer, wgpu::Buffer)>,
    /// Per page with triangles: what was baked on it, and its indices.
    pages: Vec<(wgpu::BindGroup, Range<u32>)>,
    /// The hull in its own space, for the test against the near plane.
    hull: Hull,
    hierarchy: MeshHierarchy,
}

impl TextureVolume {
    /// Uploads a texture: each page as a 3-D texture, or its weights as an array of textures with four terms per layer. O(samples).
    /// Each page is copied once more on the way; with [`Filtering::Float16`], or of terms, twice.
    ///
    /// # Errors
    /// [`RendererError::TextureTooLarge`] where a page exceeds the device's textures, [`RendererError::MeshTooLarge`] where the hull
    /// exceeds its buffers, before anything is allocated.
    pub fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        texture: &SilhouetteTexture,
        filtering: Filtering,
    ) -> Result<Self, RendererError> {
        check_sides(&device.limits(), texture)?;
        let form = VolumeForm::new(texture, filtering);
        let parts = texture.parts();
        let bounds = parts.hull.mesh().bounds();
        let frame = LocalFrame::new(bounds.as_ref());
        let vertices = TextureVertices::new(texture, &frame);
        let buffers = vertices.upload(device, queue)?;
        let mut upload = Upload { device, queue, texture, filtering, bytes: 0 };
        let layout = form.layout(device);
        let pages =
            vertices.pages.iter().map(|(page, range)| (upload.page(&layout, *page as usize), range.clone())).collect();
        let buffer_bytes = buffers.iter().map(|(vertices, triangles)| vertices.size() + triangles.size()).sum::<u64>();
        Ok(Self {
            form,
            frame,
            radius: texture.unit(),
            bounds,
            azimuths: parts.size.azimuths,
            bytes: upload.bytes + buffer_bytes,
            buffers,
            pages,
            hierarchy: MeshHierarchy::new(parts.hull.mesh()),
            hull: parts.hull.clone(),
        })
    }

    /// Its form, for [`TexturePipelines`](super::TexturePipelines).
    pub fn form(&self) -> VolumeForm {
        self.form
    }

    /// Bytes on the device.
    pub fn bytes(&self) -> u64 {
        self.bytes
    }

    /// Bounds of the hull in the object's own space; `None` without triangles.
    pub fn bounds(&self) -> Option<Bounds> {
        self.bounds
    }

    /// The frame that the hull's vertices are in.
    pub(super) fn frame(&self) -> &LocalFrame {
        &self.frame
    }

    /// The unit of gaps in the object's own space.
    pub(super) fn radius(&self) -> f64 {
        self.radius
    }

    pub(super) fn azimuths(&self) -> u32 {
        self.azimuths
    }

    /// Whether a view begins inside the hull. See [`meets_hull`].
    pub(super) fn is_met_by(&self, view: &FrameView) -> bool {
        self.bounds.is_some_and(|bounds| meets_hull(self.hull.mesh(), &self.hierarchy, &bounds, view))
    }

    /// Draws every triangle once with the pipeline that is set: one draw per page.
    pub(super) fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        let Some((vertices, triangles)) = &self.buffers else { return };
        pass.set_vertex_buffer(0, vertices.slice(..));
        pass.set_index_buffer(triangles.slice(..), wgpu::IndexFormat::Uint32);
        for (page, indices) in &self.pages {
            pass.set_bind_group(2, page, &[]);
            pass.draw_indexed(indices.clone(), 0, 0..1);
        }
    }
}

impl fmt::Debug for TextureVolume {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("TextureVolume").field("form", &self.form).field("bytes", &self.bytes).finish_non_exhaustive()
    }
}

/// `Err` where a page exceeds the device's textures.
pub(super) fn check_sides(limits: &wgpu::Limits, texture: &SilhouetteTexture) -> Result<(), RendererError> {
    let parts = texture.parts();
    let size = parts.size;
    let side = size.width.max(size.height);
    let check = |what, texels, limit, instead| {
        if texels <= limit { Ok(()) } else { Err(RendererError::TextureTooLarge { what, texels, limit, instead }) }
    };
    let more_pages = "bake more and smaller pages";
    check(
        "colours and normals of a page",
        side.saturating_mul(parts.detail),
        limits.max_texture_dimension_2d,
        more_pages,
    )?;
    check("gaps of a page", side, limits.max_texture_dimension_2d, more_pages)?;
    match &parts.angles {
        Angles::Terms(terms) => {
            let layers = terms.functions.len().div_ceil(4) as u32;
            check("layers of terms", layers, limits.max_texture_array_layers, "keep fewer terms")?;
            check("azimuths", size.azimuths, limits.max_texture_dimension_2d, "bake fewer")
        }
        Angles::Unorm8(_) | Angles::Float16(_) => {
            check("angles of a page", side, limits.max_texture_dimension_3d, more_pages)?;
            check("azimuths", size.azimuths, limits.max_texture_dimension_3d, "bake fewer")
        }
    }
}

/// Makes the textures of pages.
struct Upload<'a> {
    device: &'a wgpu::Device,
    queue: &'a wgpu::Queue,
    texture: &'a SilhouetteTexture,
    filtering: Filtering,
    bytes: u64,
}

impl Upload<'_> {
    fn page(&mut self, layout: &wgpu::BindGroupLayout, page: usize) -> wgpu::BindGroup {
        let parts = self.texture.parts();
        let size = parts.size;
        let flat = [size.width, size.height, 1];
        let fine = [size.width * parts.detail, size.height * parts.detail, 1];
        let [texels, details] = [flat, fine].map(|[width, height, _]| width as usize * height as usize);
        let d2 = TextureViewDimension::D2;
        // Without detail there is one black texel.
        let fine = if parts.detail == 0 { [1; 3] } else { fine };
        let colors = self.texels(d2, fine, TextureFormat::Rgba8Unorm, of_page(&parts.colors, page, details));
        let normals = self.texels(d2, fine, TextureFormat::Rgba16Float, of_page(&parts.normals, page, details));
        let gaps = self.texels(d2, flat, TextureFormat::R16Float, of_page(&parts.gaps, page, texels));
        let centers = match &parts.texel_centers {
            Some(centers) => self.texels(d2, flat, TextureFormat::Rgba16Float, of_page(centers, page, texels)),
            None => self.texels::<[f16; 4]>(d2, [1; 3], TextureFormat::Rgba16Float, &[]),
        };
        let mut views = vec![colors, normals, gaps, centers];
        match &parts.angles {
            Angles::Terms(terms) => {
                views.push(self.weights(terms, page, texels));
                views.push(self.functions(terms));
            }
            Angles::Unorm8(values) => {
                let values = of_page(values, page, texels * size.azimuths as usize);
                views.push(
                    self.angles(TextureFormat::R8Unorm, values, |&value| f16::from_f32(f32::from(value) / 255.0)),
                );
            }
            Angles::Float16(values) => {
                let values = of_page(values, page, texels * size.azimuths as usize);
                views.push(self.angles(TextureFormat::R16Float, values, |&value| value));
            }
        }
        let sampler = self.device.create_sampler(&wgpu::SamplerDescriptor {
            label: Some("silhouette texture"),
            address_mode_w: wgpu::AddressMode::Repeat,
            mag_filter: wgpu::FilterMode::Linear,
            min_filter: wgpu::FilterMode::Linear,
            ..wgpu::SamplerDescriptor::default()
        });
        let views = views.iter().map(wgpu::BindingResource::TextureView);
        let resources: Vec<_> = std::iter::once(wgpu::BindingResource::Sampler(&sampler)).chain(views).collect();
        bind_group(self.device, "silhouette texture: page", layout, &resources)
    }

    fn angles<T: bytemuck::Pod>(
        &mut self,
        format: TextureFormat,
        values: &[T],
        float: impl Fn(&T) -> f16,
    ) -> wgpu::TextureView {
        let size = self.texture.parts().size;
        let size = [size.width, size.height, size.azimuths];
        if self.filtering == Filtering::Float16 {
            let values: Vec<f16> = values.iter().map(float).collect();
            self.texels(TextureViewDimension::D3, size, TextureFormat::R16Float, &values)
        } else {
            self.texels(TextureViewDimension::D3, size, format, values)
        }
    }

    /// Four terms per layer, 0 to 1.
    fn weights(&mut self, terms: &Terms, page: usize, texels: usize) -> wgpu::TextureView {
        let size = self.texture.parts().size;
        let count = terms.functions.len();
        let layers = count.div_ceil(4).max(1);
        let all = self.texture.parts().size.texels() as usize;
        let mut weights = vec![[0_u8; 4]; texels * layers];
        for term in 0..count {
            let of_term = of_page(&terms.weights[term * all..], page, texels);
            let layer = &mut weights[term / 4 * texels..];
            layer.iter_mut().zip(of_term).for_each(|(texel, &weight)| texel[term % 4] = weight);
        }
        let size = [size.width, size.height, layers as u32];
        if self.filtering == Filtering::Float16 {
            let weights: Vec<_> =
                weights.iter().map(|texel| texel.map(|weight| f16::from_f32(f32::from(weight) / 255.0))).collect();
            self.texels(TextureViewDimension::D2Array, size, TextureFormat::Rgba16Float, &weights)
        } else {
            self.texels(TextureViewDimension::D2Array, size, TextureFormat::Rgba8Unorm, &weights)
        }
    }

    /// A column per azimuth: a row per layer of weights, with their scales; then the sum of all offsets.
    fn functions(&mut self, terms: &Terms) -> wgpu::TextureView {
        let azimuths = self.texture.parts().size.azimuths as usize;
        let layers = terms.functions.len().div_ceil(4).max(1);
        let mut table = vec![[0.0_f32; 4]; azimuths * (layers + 1)];
        for (term, function) in terms.functions.iter().enumerate() {
            for (azimuth, value) in function.iter().enumerate() {
                table[term / 4 * azimuths + azimuth][term % 4] = terms.scales[term] * value;
                table[layers * azimuths + azimuth][0] += terms.offsets[term] * value;
            }
        }
        let size = [azimuths as u32, layers as u32 + 1, 1];
        self.texels(TextureViewDimension::D2, size, TextureFormat::Rgba32Float, &table)
    }

    /// A texture of these texels, or of zeros without any.
    fn texels<T: bytemuck::Pod>(
        &mut self,
        view: TextureViewDimension,
        [width, height, depth]: [u32; 3],
        format: TextureFormat,
        texels: &[T],
    ) -> wgpu::TextureView {
        let size = wgpu::Extent3d { width, height, depth_or_array_layers: depth };
        let is_deep = view == TextureViewDimension::D3;
        let texture = self.device.create_texture(&wgpu::TextureDescriptor {
            label: Some("silhouette texture"),
            size,
            mip_level_count: 1,
            sample_count: 1,
            dimension: if is_deep { wgpu::TextureDimension::D3 } else { wgpu::TextureDimension::D2 },
            format,
            usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
            view_formats: &[],
        });
        let row = width * size_of::<T>() as u32;
        self.bytes += u64::from(row) * u64::from(height) * u64::from(depth);
        if !texels.is_empty() {
            let layout =
                wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(row), rows_per_image: Some(height) };
            self.queue.write_texture(texture.as_image_copy(), bytemuck::cast_slice(texels), layout, size);
        }
        texture.create_view(&wgpu::TextureViewDescriptor { dimension: Some(view), ..Default::default() })
    }
}

/// The part of a page, which has `count` values.
fn of_page<T>(values: &[T], page: usize, count: usize) -> &[T] {
    &values[page * count..][..count]
}
