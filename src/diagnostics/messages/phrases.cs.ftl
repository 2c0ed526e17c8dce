### Slova, která stojí anglicky přímo v programu, a jejich české protějšky: zprávy příkazů plan, convert a crosscheck.

## Efekty, jak je jmenuje zpg plan

term-ambient = ambientní světlo
term-diffuse = difuzní odraz
term-shadows = stíny
term-transparent-shadows = průhledné stíny
term-reflection = zrcadlový odraz
term-refraction = lom
term-dispersion = disperze
term-vertex-colour = barvy z profilu
term-smooth-normals = hladké normály
term-csg = množinové operace
term-unbounded = nekonečná tělesa
term-clip-box = oříznutí kvádrem
term-stereo = stereo

## Co efekt stojí, nebo proč se nepočítá

term-one-addition-at-each-diffuse-point = jeden součet v každém difuzním bodě
term-no-ambient-light-or-nothing-diffuse-to-be-lit = není ambientní světlo, nebo není nic difuzního, co by osvětlilo
term-a-cosine-for-each-light-at-each-diffuse-point = jeden kosinus pro každé světlo v každém difuzním bodě
term-no-point-light-that-shines-or-nothing-diffuse-to-be-lit = nesvítí bodové světlo, nebo není nic difuzního, co by osvětlilo
term-a-ray-to-each-light-that-a-diffuse-point-faces = jeden paprsek ke každému světlu, k němuž je difuzní bod přivrácen
term-no-diffuse-light-or-a-lone-convex-shape-that-nothing-can-be-in-the-way-of = není difuzní světlo, nebo je tu jediný konvexní tvar, kterému nic nestojí v cestě
term-shadow-rays-that-meet-something-transparent-list-all-surfaces-on-their-way = u stínového paprsku, který narazí na něco průhledného, se hledají všechny plochy na jeho cestě
term-no-shadows-or-nothing-that-lets-light-through = nejsou stíny, nebo nic nepropouští světlo
term-a-ray-at-each-mirroring-or-totally-reflecting-point = jeden paprsek v každém bodě, který zrcadlí nebo úplně odráží
term-nothing-mirrors-and-no-medium-can-reflect-light-totally = nic nezrcadlí a v žádném prostředí nemůže dojít k úplnému odrazu
term-a-ray-at-each-transparent-point-and-the-media-on-both-sides = jeden paprsek v každém průhledném bodě a prostředí po obou stranách
term-nothing-lets-light-through-kt-is-0-wherever-it-shows = nic nepropouští světlo: všude, kde je to vidět, je kt 0
term-up-to-three-rays-at-points-where-the-indices-differ = až tři paprsky v bodech, kde se indexy lomu liší
term-nothing-transparent-or-one-index-for-all-channels = nic průhledného, nebo jediný index lomu pro všechny kanály
term-surface-coordinates-and-a-pixel-at-each-diffuse-point-that-has-one = souřadnice na povrchu a jeden pixel v každém difuzním bodě, který ji má
term-no-image-texture-shows = žádná obrazová textura není vidět
term-the-point-in-the-painted-object-s-space-at-each-diffuse-point-that-has-one = přepočet bodu do souřadnic obarveného objektu v každém difuzním bodě, který ji má
term-no-solid-texture-shows = žádná objemová textura není vidět
term-surface-coordinates-at-each-diffuse-point-that-has-one = souřadnice na povrchu v každém difuzním bodě, který ji má
term-no-checkerboard-shows = žádná šachovnice není vidět
term-a-colour-from-the-shape-itself-at-each-diffuse-point-that-has-one = barva ze samotného tvaru v každém difuzním bodě, který ji má
term-no-shape-shows-colours-of-its-own = na žádném tvaru nejsou vidět vlastní barvy
term-a-second-normal-at-each-point-that-has-one = druhá normála v každém bodě, který ji má
term-no-shape-that-shows-has-normals-of-its-own = žádný viditelný tvar nemá vlastní normály
term-lists-of-crossings-for-rays-that-come-near = seznam průsečíků pro každý paprsek, který vede blízko
term-unions-only-the-nearest-crossing-is-enough = jen sjednocení: stačí nejbližší průsečík
term-a-test-for-every-ray-since-no-box-can-spare-it = jeden test pro každý paprsek: bez kvádru kolem tělesa ho nelze vynechat
term-everything-has-bounds = všechno má meze
term-every-ray-is-cut-to-the-region-and-may-start-inside-of-solids = každý paprsek se ořízne na danou oblast a může začít uvnitř těles
term-no-region-to-be-drawn-or-all-of-the-scene-lies-in-it = není zadána žádná oblast, nebo v ní leží celá scéna
term-two-pictures = dva obrázky
term-one-picture = jeden obrázek
term-two-points-through-the-inverse-matrix-for-each-camera-ray = dva body vynásobené inverzní maticí pro každý paprsek kamery
term-the-camera-has-a-field-of-view = kamera má zorný úhel

## Kdo efekt zapíná: „řádek 3: 7 …“

term-is-a-point-light = je bodové světlo
term-draws-a-scene-without-any-light-so-the-camera-brings-a-headlight = vykresluje scénu bez světel, takže svítí světlo u kamery
term-is-an-ambient-light = je ambientní světlo
term-is-diffuse = odráží světlo difuzně
term-lets-light-through-so-its-shadow-is-not-black = propouští světlo, takže jeho stín není černý
term-mirrors-its-ks-is-not-0 = zrcadlí: jeho ks není 0
term-has-a-refractive-index-that-can-reflect-light-totally = má index lomu, při němž může dojít k úplnému odrazu
term-lets-light-through-its-kt-is-not-0 = propouští světlo: jeho kt není 0
term-has-refractive-indices-that-differ-between-channels = má v různých kanálech různé indexy lomu
term-has-an-image-texture = má obrazovou texturu
term-has-a-solid-texture = má objemovou texturu
term-has-a-checkerboard = má šachovnici
term-has-colours-of-its-own-and-none-is-painted-over-them = má vlastní barvy a žádná jiná je nepřekrývá
term-has-normals-of-its-own = má vlastní normály
term-is-an-intersection-a-difference-or-a-complement = je průnik, rozdíl nebo doplněk
term-goes-on-without-end = sahá do nekonečna
term-is-a-complement-which-goes-on-without-end = je doplněk, a ten sahá do nekonečna
term-draws-a-region-that-cuts-the-scene = vykresluje jen oblast, která scénu řeže
term-is-one-of-the-two-cameras = je jedna ze dvou kamer
term-has-a-projection-matrix = má matici projekce

## Vlastnosti scény, jak je jmenují zprávy o převodech

term-diffuse-light = difuzní světlo
term-shadows-of-transparent-objects = stíny průhledných objektů
term-refractive-index-by-channel = index lomu po kanálech
term-total-internal-reflection = úplný odraz
term-colours-along-a-profile = barvy podél profilu
term-shading-normals = normály pro stínování
term-background = pozadí
term-render-box = kvádr renderovacího záznamu
term-automatic-camera = automatická kamera
term-headlight = světlo u kamery
term-depth-of-rays = hloubka paprsků
term-cutoff-of-faint-rays = vynechání slabých paprsků
term-bounding-volumes-left-out = vynechané obalové kvádry a koule
term-camera-far-away = vzdálená kamera
term-pictures-whose-paths-are-not-ascii = obrázky, jejichž cesty nejsou v ASCII
term-pov-ray-cannot-open-them-choose-a-file-with-o = POV-Ray je neotevře: zadejte soubor volbou -o
term-cameras-whose-pixels-are-not-squares = kamery, jejichž pixely nejsou čtverce
term-colours-above-1 = barvy nad 1
term-cut-faces-of-composite-objects = řezy složených objektů
term-cut-faces-through-overlapping-parts-that-are-seen-from-within = řezy překrývajícími se částmi, které jsou vidět zevnitř
term-cut-faces-through-overlapping-transparent-parts = řezy překrývajícími se průhlednými částmi
term-depth-of-rays-in-parts-that-others-surround = hloubka paprsků v částech uvnitř jiných
term-depth = hloubka paprsků
term-narrow-gaps-behind-transparent-surfaces = úzké mezery za průhlednými plochami
term-near-plane-of-the-projection-matrix = přední rovina matice projekce
term-operations-on-media-of-different-index = operace s prostředími různého indexu lomu
term-operations-that-failed = operace, které se nezdařily
term-overlapping-parts-that-were-not-joined = překrývající se části, které se nespojily
term-parallel-rays = rovnoběžné paprsky
term-parts-of-one-medium-that-overlap-with-another-medium-between-them = překrývající se části jednoho prostředí a mezi nimi jiné prostředí
term-parts-without-end = nekonečné části
term-refraction-in-solids-that-the-render-box-cuts-open = lom v tělesech, která otevírá kvádr renderovacího záznamu
term-surfaces-in-one-place = plochy na jednom místě
term-faces-in-one-place = stěny na jednom místě
term-things-that-are-small-beside-what-is-far-away = malé objekty vedle vzdálených
term-vertex-normals-of-different-length = normály ve vrcholech různé délky
term-crowds-of-overlapping-parts-of-many-media = mnoho překrývajících se částí z mnoha prostředí
term-transparent-parts-that-meet-or-overlap = průhledné části, které se dotýkají nebo překrývají
term-solids-that-end-flush-with-others = tělesa, která končí v jedné rovině s jinými

## Co je přibližné, nebo proč je něco vynecháno

term-an-operand-was-left-as-it-is = operand zůstal, jak je
term-both-are-there-one-in-the-other = jsou tam oba, jeden ve druhém
term-cut-to-the-render-box = oříznuto kvádrem renderovacího záznamu
term-1-instead-mitsuba-knows-none = místo nich 1: takové barvy Mitsuba nezná
term-which-of-them-is-seen-is-up-to-rounding-and-the-tolerance = o tom, která je vidět, rozhoduje zaokrouhlování a tolerance
term-which-is-seen-is-up-to-rounding = o tom, která je vidět, rozhoduje zaokrouhlování
term-pixels-are-made-square-and-no-size-helps = pixely budou čtvercové; žádná --size nepomůže
term-off-by-less-than-a-thousandth-of-the-difference-between-two-normals = chyba je menší než tisícina rozdílu dvou normál
term-faces-between-the-parts-may-show-twice = stěny mezi částmi mohou být vidět dvakrát
term-faces-between-the-parts-show = stěny mezi částmi jsou vidět
term-where-parts-overlap-the-mean-of-their-textures-textures-laid-on-shapes-are-misplaced = kde se části překrývají, je průměr jejich textur; textury položené na tvary jsou posunuté
term-light-that-goes-through-faces-between-the-media-may-take-another-way-and-show-another-picture = světlo, které prochází stěnami mezi prostředími, může jít jinudy a ukázat jiný obrázek
term-what-is-seen-through-the-overlap-may-be-another-picture = skrz překryv může být vidět něco jiného
term-what-lies-between-the-camera-and-the-near-plane-is-seen = co leží mezi kamerou a přední rovinou, je vidět
term-moved-by-a-billionth-of-the-picture = posunuto o miliardtinu obrázku
term-so-that-none-runs-exactly-along-a-face = aby žádný neběžel přesně podél stěny
term-rays-that-enter-through-the-cut-leave-the-solid-as-if-they-entered-it = paprsky, které vstoupí řezem, vystupují, jako by teprve vstupovaly
term-light-that-is-mirrored-there-takes-two-steps-more = odražené světlo tam potřebuje o dva kroky víc
term-light-goes-through-the-faces-within-them-too = světlo prochází i stěnami uvnitř nich
term-a-material-of-mtl = materiál MTL
term-a-physically-based-material = fyzikálně založený materiál
term-straight-between-the-points-of-the-mesh = mezi body sítě lineárně
term-straight-between-the-points-of-a-mesh = mezi body sítě lineárně
term-one-colour-a-triangle-or-point = jedna barva na trojúhelník nebo bod
term-one-colour-a-triangle = jedna barva na trojúhelník
term-a-mesh-has-no-lights = síť nemá světla
term-a-mesh-has-no-camera = síť nemá kameru
term-a-mesh-has-no-background = síť nemá pozadí
term-a-ply-file-has-colours-only = soubor PLY má jen barvy
term-a-material = materiál
term-between-the-points-of-the-mesh = mezi body sítě
term-what-it-cuts-is-closed = co ořízne, to uzavře
term-ends-at-a-thousand-times-the-scene-s-size = končí v tisícinásobku velikosti scény
term-exact-where-rays-are-parallel-or-pixels-square = přesně, kde jsou paprsky rovnoběžné nebo pixely čtvercové
term-a-mixture-by-the-strongest-channel-with-fresnel-s-law-where-light-is-bent = směs podle nejsilnějšího kanálu; kde se světlo láme, podle Fresnelových vztahů
term-light-that-what-is-near-keeps-out = chybí světlo, které zacloní blízké plochy
term-as-bright-as-ours-at-the-scene-s-middle-it-fades-with-distance = uprostřed scény stejně jasné jako v zpg; se vzdáleností slábne
term-light-between-surfaces-comes-in-addition = navíc světlo odražené z plochy na plochu
term-full-behind-what-bends-light = za tím, co láme světlo, je plný stín
term-with-fresnel-s-law = podle Fresnelových vztahů
term-the-mean-of-the-channels-exact-in-three-passes = průměr kanálů; třemi průchody přesně
term-at-the-points-of-a-mesh = v bodech sítě
term-it-lights-the-scene-beside-ambient-light-that-is-seen-instead = osvětluje scénu; je-li ve scéně ambientní světlo, je místo pozadí vidět to
term-the-mirrored-ray-counts-with-weight-1-instead-of-ks-kt = odražený paprsek má váhu 1 místo ks + kt
term-a-light-behind-the-triangle-but-before-its-shading-normal-is-seen = světlo, které je za trojúhelníkem, ale před jeho normálou pro stínování, je vidět

## Jak je co zapsáno

term-steps-one-after-the-other-are-one-matrix = transformace jdoucí po sobě jsou složeny do jedné matice
term-an-image-must-lie-in-the-folder-of-its-scene = obrázek musí ležet ve složce své scény
term-as-the-properties-that-were-assigned = jako vlastnosti, které byly přiřazeny
term-there-is-nothing-to-draw = není co vykreslit
term-triangles = trojúhelníky
term-applied-to-the-points = už použito na body
term-cut-and-joined-as-meshes = rozříznuto a spojeno jako sítě
term-kd-ks-tf-ni = Kd, Ks, Tf, Ni
term-metallic-roughness-transmission-index = kovovost, drsnost, propustnost, index lomu
term-a-picture = obrázek
term-left-out-it-never-changes-the-picture = vynecháno: obrázek to nikdy nemění
term-up-to-the-program-that-shows-the-mesh = záleží na programu, který síť zobrazuje
term-normals-of-the-mesh = normály sítě
term-everything-is-cut-to-it = všechno je jím oříznuto
term-left-to-the-viewer = ponecháno prohlížeči
term-a-mesh = síť
term-cube = krychle
term-rectangles = obdélníky
term-a-mesh-of-the-same-facets = síť ze stejných plošek
term-orthographic-perspective-with-principal-point-offset = orthographic, perspective s principal_point_offset
term-shapes-side-by-side-those-of-one-clear-medium-are-joined = tvary vedle sebe; ty z jednoho průhledného prostředí jsou spojené
term-cut-as-meshes = rozříznuto jako sítě
term-diffuse-conductor-dielectric = diffuse, conductor, dielectric
term-int-ior-ext-ior = int_ior, ext_ior
term-bitmap = bitmap
term-mesh-attribute = mesh_attribute
term-a-constant-emitter = zářič constant
term-a-point-emitter = zářič point
term-perspective = perspective
term-one-file-for-each-eye = jeden soubor pro každé oko
term-path = path
term-point-lights-are-no-caustics = bodová světla nevytvářejí kaustiky
term-dielectric = dielectric
term-as-the-head-of-the-file-says = jak říká hlavička souboru
term-what-it-cuts-is-a-mesh-and-open = co ořízne, je síť, a ta zůstane otevřená
term-the-camera-is-written-out = kamera je zapsána
term-max-depth = max_depth
term-paths-end-at-random-which-is-right-on-average = dráhy končí náhodně, v průměru to vychází správně
term-matrix = matrix
term-location-direction-right-and-up = location, direction, right a up
term-union-of-transparent-parts-merge = union, u průhledných částí merge
term-inverse = inverse
term-the-same-object-declared-once = týž objekt, jednou deklarovaný
term-finish-kt-as-a-filter = finish, kt jako filtr
term-interior-ior = interior {"{"} ior {"}"}
term-pov-ray-decodes-the-picture-itself-with-o-it-is-copied-as-png = POV-Ray dekóduje obrázek sám; s -o se zkopíruje jako PNG
term-image-map-through-the-surface-coordinates = image_map podle souřadnic na povrchu
term-a-function-pigment = pigment daný funkcí
term-light-source-without-fading = light_source bez slábnutí
term-bounded-by-where-it-is-proved-to-hold-the-object = bounded_by, kde je dokázáno, že objekt obsahuje
term-kt-of-each-surface-on-the-way = kt každé plochy po cestě
term-three-passes-channel-0-1-and-2 = tři průchody, Channel 0, 1 a 2
term-a-pigment-over-the-profile = pigment podél profilu
term-smooth-triangle = smooth_triangle
term-clipped-by = clipped_by
term-a-light-source-at-the-camera = light_source u kamery
term-max-trace-level = max_trace_level
term-adc-bailout-0-all-rays-are-followed = adc_bailout 0: sledují se všechny paprsky
term-lathe-linear-spline = lathe {"{"} linear_spline {"}"}
term-lathe-linear-spline-the-colours-as-a-pigment = lathe {"{"} linear_spline {"}"}, barvy jako pigment
term-polygon = polygon
term-poly-2 = poly {"{"} 2 {"}"}
term-written-as-they-are = zapsáno beze změny
term-cutaway-textures = cutaway_textures
term-an-object-has-one-index-there = objekt tam má jediný index lomu
term-made-longer-where-nobody-sees-them = prodlouženo tam, kde to není vidět
term-faces-between-them-stand-a-hair-apart = stěny mezi nimi jsou od sebe nepatrně vzdáleny

## Co je divného na jiném programu

term-its-picture-cannot-be-read = jeho obrázek nelze přečíst
term-it-has-written-no-picture = nezapsal žádný obrázek
term-its-picture-is-of-another-size = jeho obrázek má jinou velikost
term-its-picture-is-too-large = jeho obrázek je příliš velký
term-what-it-has-written-is-of-another-size = co zapsal, má jinou velikost

## Co navrhují editory

term-the-next-free-id = další volné ID
term-none = žádná
term-picture = obrázek
term-the-x-axis = osa x
term-the-y-axis = osa y
term-the-z-axis = osa z
term-one-sheet = jednodílný
term-two-sheets = dvojdílný
