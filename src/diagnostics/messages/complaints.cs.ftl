### Co se netýká místa ve scéně, česky: soubory, nastavení, přání na příkazové řádce.

## Slova kolem a slova cizí

quoted = { $text }
at-place = { $path }:{ $line }:{ $column }: { $why }
at-line = { $path }:{ $line }: { $why }

## Soubory

no-scene = { $path } není scéna
no-picture = { $path } není obrázek
cannot-read = { $path } nelze přečíst: { $reason }
cannot-write = { $path } nelze zapsat: { $reason }
cannot-print = na standardní výstup nelze zapisovat: { $reason }
not-found-but = takový soubor není, ale je zde { $path }
too-large = soubor je větší než { $size } GiB
picture-broken = je poškozený, nebo má podobu, kterou zpg nečte
picture-too-wide = má { $width } × { $height } pixelů; přečte se nejvýše { $side } × { $side }
pictures-too-large = obrázky jedné scény smějí zabrat dohromady 256 MiB
cannot-write-in-place = { $path } nelze zapsat: { $reason }; původní obsah je uložen v { $copy }
no-folder = složka { $path } neexistuje
read-only-file = soubor je jen pro čtení
no-regular-file = není to obyčejný soubor
wrong-ending = { $path } končí na { $ending }, ale zapisuje se něco jiného: zvolte jméno, které končí na { $right }
scene-name = jméno scény končí na .zpg: napište { $right }
file-is-there = { $path } už existuje: zvolte jiné jméno, nebo ho --force přepíše
scene-is-there = { $path } je scéna, která už existuje: zvolte jiné jméno, nebo ji --force přepíše
other-ending = { $path } je podle jména soubor jiného programu ({ $ending }) a zůstává, jak je; změní ho jen --force
text-lost = v kódování { $encoding } by se některé znaky ztratily
no-scene-any-more = číslem by pak začínalo příliš málo řádků, nebo by v záznamech leželo příliš málo čísel, a soubor by se už nečetl jako scéna
layout-changes-content = vnitřní chyba: { $path } by po zformátování neříkal totéž, a tak zůstává, jak je; nahlaste to, prosím
no-scenes = ve složce { $path } není žádný soubor se scénou (*.zpg)

io-not-found = soubor nebo složka neexistuje
io-denied = přístup odepřen
io-is-a-directory = je to složka
io-not-a-directory = není to složka
io-full = na disku není místo
io-read-only = disk je jen pro čtení

## Nastavení

in-file = { $path }:{ $line }:{ $column }: { $why }
setting-toml = toto není TOML
setting-truth = { $text } není hodnota TOML: napište `true` nebo `false`
setting-quotes = { $text } není hodnota TOML: text patří do uvozovek, napište { $right }
setting-unknown = nastavení { $key } neexistuje; existují { $known }
setting-codes-known = kódy s úrovní, například `W310 = "off"`, a `per-file-ignores`
setting-value = `{ $key }`: očekává se { $wanted }, uvedeno je { $found }
setting-glob = { $text } není vzor jmen souborů
setting-table = tabulka
setting-level = jedno z `error`, `warning`, `note`, `off`
setting-codes = seznam kódů, například ["W307", "style"]
setting-patterns = seznam vzorů jmen souborů, například ["old", "*/draft.zpg"]
setting-width = celé číslo (šířka je od 20 do 1000)
setting-bool = true nebo false
setting-numbers = "shortest" nebo "keep"
config-neither = --config: soubor { $path } neexistuje; nastavení se píše jako lint.W310=off
config-setting = --config { $text }: { $why }
config-two-files = --config uvádí dva soubory s nastavením, { $first } a { $second }: zadejte jen jeden
config-isolated = --config { $path } nelze zadat spolu s --isolated: to žádný soubor s nastavením nečte

## Kódy a témata

no-code-of = kód { $text } neexistuje
no-code = kód { $text } neexistuje (všechny vypíše `zpg explain`)
always-error = { $code } je vždy chyba
error-not-ignored = { $code } je vždy chyba a nelze ji vynechat
statistics-format = statistika je text nebo JSON: --format human nebo json
no-topic = žádný nález ani typ záznamu se nejmenuje { $text }
no-topic-list = žádný nález ani typ záznamu se nejmenuje { $text } (všechny vypíše `zpg explain`)

## Sledování

stdin-not-watched = standardní vstup nelze sledovat
watch-no-width = `-w` sleduje změny scény a { $text } k němu nepatří: velikost se zadává třeba `--size 64x48`
cannot-watch = změny nelze sledovat
watching = Sleduji změny; konec Ctrl-C

## Formátování

would-reformat = přeformátoval by se: { $path }
would-be-reformatted = { $count ->
    [one] { $count } soubor by se přeformátoval
    [few] { $count } soubory by se přeformátovaly
   *[other] { $count } souborů by se přeformátovalo
}
reformatted = { $count ->
    [one] { $count } soubor přeformátován
    [few] { $count } soubory přeformátovány
   *[other] { $count } souborů přeformátováno
}
left-unchanged = { $count ->
    [one] { $count } soubor beze změny
    [few] { $count } soubory beze změny
   *[other] { $count } souborů beze změny
}
list-comma = { $first }, { $last }
range-behind-end = řádků je v souboru { $path } jen { $lines }: nic se neformátuje
layout-mistake = { $place }: { $code }: { $message }; řádky s chybami zůstanou, jak jsou, více řekne `{ $command }`
layout-mistake-stdin = { $place }: { $code }: { $message }; řádky s chybami zůstanou, jak jsou
range-of-many = --range platí jen pro jeden soubor
not-a-file = není to obyčejný soubor
stdin-and-path = `--stdin-filename` pojmenovává standardní vstup, takže { $path } se nepřečte: vynechte jedno z nich
misnamed-settings = { $path } se ignoruje: soubor s nastavením se musí jmenovat { $right }
no-files = není tu soubor se scénou, jehož nastavení by šlo ukázat

## Vykreslování a dotazy

cannot-draw = nelze vykreslit { $what } (objekt { $id })
draw-nothing = není co vykreslit: ve scéně chybí renderovací záznam
draw-no-picture = texturu bez obrázku
draw-matrix = transformaci, jejíž inverze je mimo rozsah čísel
draw-projection = pohled kamery s touto projekcí
crop-too-large = --crop přesahuje obrázek o velikosti { $width }x{ $height } pixelů
too-many-pixels = obrázek má nejvýše { $max } pixelů
picture-needs-memory = obrázek by zabral { $needed } paměti, ale --memory povoluje { $memory }: zvolte menší --size nebo --crop
file-needs-memory = je tak dlouhý, že by potřeboval asi { $needed } paměti, ale --memory povoluje { $memory }
too-many-parts-in-one-place = scéna má { $parts } částí, počítá-li se každý výskyt, a tolik jich leží přes sebe, že by paprsky potřebovaly víc, než povoluje --memory { $memory }: zmenšete překryv kopií, nebo povolte více paměti
expected-memory = očekává se množství paměti, například 800M nebo 12G
fewer-threads = --threads { $wanted } je příliš mnoho; spustí se jich { $most }, čtyři na každý procesor
no-threads = vlákna nelze spustit
ctrl-c-leaves = po Ctrl-C mohou zůstat dočasné soubory
ctrl-c-leaves-programs = po Ctrl-C mohou jiné programy běžet dál
heatmap-scale = mapa nákladů: testy průsečíků na pixel, od 0 (černá) do { $max } (světle žlutá), ve stupnici log(1 + n)
unknown-format = formát souboru { $path } nelze poznat: jméno má končit na .png, .jpg, .webp, .exr nebo .pfm
unseen-outside = mimo kvádr renderovacího záznamu
unseen-inside = uvnitř neprůhledného tělesa { $id } ({ $type })
map-is-png = mapa nákladů je obrázek PNG: jméno má končit na .png, ne { $path }

no-such-camera = scéna nemá kameru { $id }; kamery scény: { $cameras }
no-cameras = scéna nemá kameru { $id }: nemá vůbec žádnou
stereo-of-one = --stereo potřebuje dvě kamery, ale obrázek pořizuje jedna: ve scéně chybí výběr dvojice kamer (typ -503), nebo jednu kameru vybírá --camera
two-on-stdout = na standardní výstup lze poslat jen jeden z výstupů: pro druhý zvolte soubor
pair-on-stdout = dva obrázky nelze poslat na standardní výstup: zvolte --stereo side-by-side nebo --stereo anaglyph
note-left-eye = ze dvou kamer se použije levá, { $id }; druhou zvolí `--camera`
note-no-camera = scéna nemá kameru: zobrazí se zprava, zepředu a shora
note-comma = řádek { $line }: { $text } se čte jako dvě čísla, { $number }; je-li to jedno, napište desetinnou tečku{ $more ->
    [0] { "" }
   *[other] {" "}(takových je ještě { $more })
}
note-undrawn = { $count ->
    [one] { $count } objekt se nezobrazí: který, řekne
    [few] { $count } objekty se nezobrazí: které, řekne
   *[other] { $count } objektů se nezobrazí: které, řekne
} `zpg check`
note-no-light = scéna nemá světlo: přidá se ambientní světlo a bodové světlo nad kamerou a vlevo od ní
note-nothing-in-view = v záběru nic není; celou scénu ukáže `--view iso`
note-nothing-to-see = ve scéně není nic, co by bylo vidět; proč, řekne `zpg check`
note-camera-inside = kamera je uvnitř tělesa: obrázek ukazuje těleso zevnitř
note-nothing-lit = na nic, co je vidět, nedopadá světlo
note-too-bright-by = { $percent } % pixelů je jasnějších než bílá: záznam { $id } vydává víc světla, než dostává; co napsat, řekne `zpg check`
note-too-bright = { $percent } % pixelů je jasnějších než bílá; napraví to `--exposure { $exposure }`
note-drawn-anyway = soubor { $path } neuvádí, jaký obrázek v něm je, jako to dělá .png a .exr: vykreslí se v každém případě
note-unfinished = v souboru { $path } zůstává { $percent } % obrázku; zbytek vykreslí tentýž příkaz s `--resume`
note-other-part = { $path } je část jiného obrázku: nic se z ní nepoužije
note-earlier-job = složka { $path } obsahuje dřívější úlohu a tato ji nahrazuje: skripty a scény se zapíšou znovu; obrázky zůstávají, a které by vyšly stejně, ty se znovu nekreslí
note-one-frame = `--frames { $frame }` kreslí jen snímek { $frame }; { $frame ->
    [few] první { $frame }
   *[other] prvních { $frame }
} kreslí `--frames 0-{ $last }`
several-with-tile = `--tile` je jen pro jednu scénu
part-format = soubor { $path } nemůže uvést, která část obrázku v něm je: ať jeho jméno končí na .png nebo .exr
more-tiles-than-rows = dílů je { $count }, víc než řádků obrázku: { $height }
already-drawn = { $path } už je vykreslen
several-with-one-output = `--stats` a `--heatmap` jsou jen pro jednu scénu
too-large-for-format = obrázky jako { $path } mohou mít na šířku i na výšku nejvýše { $most } pixelů
several-on-stdout = na standardní výstup se vejde jeden obrázek: složku určete pomocí `-o`
several-in-one-file = { $path } je jeden soubor, ale scén je několik: složku určete pomocí `-o`
wrote-file = Zapsáno: { $path }
wrote-scene = Zapsáno: { $path }; vykreslí se příkazem `zpg render { $file }`
picture-not-translated = { $path } je obrázek: vykreslí ho `zpg render { $scene } -o { $path }`
no-target = do jakého formátu? Určete ho volbou `--to` ({ $names }), nebo ať jméno za `-o` končí na .pov, .xml, .ply, .obj, .glb, .stl, .json nebo .zpg
gltf-is-glb = zpg zapisuje glTF jako jeden binární soubor: pojmenujte jej `-o { $path }`
wrote-picture = Zapsáno: { $path }, { $width } × { $height } pixelů
wrote-joined = { $wrote }; odstraněno částí: { $count }
wrote-rows = Zapsáno: { $path }, řádky { $first } až { $last } z { $height }
farm-folder = ve složce { $path } je něco jiného: určete složku, která je nová, prázdná, nebo patří dřívější úloze
farm-name = { $path } nemůže být v úloze: jméno obsahuje konec řádku, nebo není v UTF-8
farm-same-name = dvě scény se jmenují { $name } a jejich obrázky by měly stejné jméno: jednu přejmenujte
farm-stdin = úloha potřebuje scény v souborech
too-many-tasks = dílčích úloh je příliš mnoho: více než 4294967295
expected-number-from-one = očekává se celé číslo od 1 do 1000000
not-drawn-by-zpg = { $path } neuvádí, které části kterého obrázku obsahuje: nezapsal ho `zpg render`, nebo ho změnil jiný program
picture-cut-off = soubor { $path } je poškozený nebo neúplný: vykreslete ho znovu
joined-format = obrázek se spojuje do .png nebo .exr, ne do { $path }
joined-whole = { $path } je celý obrázek, ne jeho část
joined-unfinished = { $path } zbyl po přerušeném `zpg render`: pokračuje v něm `zpg render --resume`
exr-of-png = { $path } má osmibitové barvy, ze kterých .exr nevznikne: vykreslete části jako .exr
no-parts = chybí části: žádný soubor nekončí na .png ani .exr
parts-left-out = vynechává se: { $paths }; část je soubor PNG nebo EXR s jiným jménem než výsledný obrázek
part-changed = soubor { $path } se během spojování změnil
part-of-another = { $path } je část jiného obrázku než { $other }: { $reason }
of-another-version = vykreslila ji jiná verze zpg
of-another-scene = scéna nebo její textura byla jiná
of-other-options = volby byly jiné
rows-twice = řádky { $first } až { $last } jsou v souboru { $path } i v souboru { $other }
rows-missing = chybí { $count } z { $height } řádků obrázku: { $rows }

# Snímky: scény, ve kterých se mění některá čísla.

no-frames = { $arg } potřebuje volbu `--frames`, která říká, jaké snímky to jsou, například --frames 0-99
frames-alike = všechny snímky by byly stejné: co se má měnit, určuje `--set`, `--orbit` nebo `--frames-from`
frames-on-stdout = snímky tvoří více obrázků: uveďte za `-o` soubor, například film.png nebo film.apng
frames-of-json = { $path } je scéna v JSON, ale měnit lze jen čísla záznamů: na záznamy ji převede `zpg convert --to zpg`
only-outside = `--only` uvádí snímky, které mezi snímky { $frames } nejsou
too-many-frames = snímků smí být nejvýše { $most }
film-of-one = { $path } zpg nezapisuje; jeden obrázek vykreslí s `-o { $still }` a animovaný s `--frames` a `-o { $animated }`
film-by-ffmpeg = soubor { $path } zpg nezapisuje: vykreslete snímky s volbou `-o { $frames }` a film z nich vytvořte příkazem `{ $line }`. S volbou `-o { $animated }` zapíše zpg samo animovaný obrázek
animation-without-frames = { $path } je animovaný obrázek: z jakých snímků má být, určuje `--frames`
animation-of-tiles = `--tile` kreslí díly snímků do souborů .png nebo .exr, ne do { $path }
fps-of-files = `--fps` patří k animovanému obrázku (.apng), a { $path } jím není
note-camera-stays = obrázek pořizuje kamera { $id }, která zůstává na místě, protože `--orbit` otáčí jinou; obě kamery dvojice (typ -503) otáčí ID záznamu dvojice
wrote-animation = Zapsáno: { $path }, { $frames ->
    [one] { $frames } snímek
    [few] { $frames } snímky
   *[other] { $frames } snímků
}, { $width } × { $height } pixelů
in-frame = snímek { $frame }: { $why }
frame-has-errors = ve scéně snímku { $frame } jsou chyby
frame-reads-otherwise = s těmito čísly se text čte jako jiné záznamy: oddělte záznamy konci řádků
in-set = --set: { $why }
in-orbit = --orbit: { $why }
in-cell = { $path }, řádek { $row }, sloupec { $column }: { $why }
empty-table = v souboru { $path } nejsou žádné řádky s čísly: pod řádkem se jmény má být jeden pro každý snímek
empty-cell = buňka je prázdná
cell-beyond = první řádek nemá jméno pro sloupec, ve kterém je `{ $text }`
rows-and-frames = `--frames` uvádí { $frames ->
    [one] { $frames } snímek
    [few] { $frames } snímky
   *[other] { $frames } snímků
}, ale tabulka má { $rows ->
    [one] { $rows } řádek
    [few] { $rows } řádky
   *[other] { $rows } řádků
} s čísly
set-twice = { $name } se má měnit dvakrát
no-record-of-id = ve scéně není záznam s ID { $id }
no-record-on-line = { $name }: na tomto řádku záznam s tímto ID nezačíná; takové záznamy začínají na řádcích { $lines }
no-such-parameter = { $name }: záznamy s ID { $id } nemají číslo tohoto jména; mají: { $known }
no-parameters = záznamy s ID { $id } nemají čísla, která by se mohla měnit
parameter-left-out = { $name } není ve scéně zapsáno: nejdříve zapište nepovinná čísla záznamu
several-parameters = { $name } může znamenat více čísel: napište jedno z { $names }
parameter-is-list = { $name }: čísla tohoto seznamu jsou { $first } až { $last }
parameter-no-list = { $name }: to je jedno číslo, ne seznam; závorky vynechte
parameter-is-whole = { $name } je celé číslo nebo jméno, a to se nemění
orbit-of-moved = kameru { $id } přemisťuje záznam na řádku { $line }: zapište její polohu a směr přímo do záznamu kamery a tento záznam vynechte
orbit-of-projection = kamera { $id } má jen matici projekce a žádnou polohu, která by se mohla otáčet: zapište před ni záznam kamery (typ -501)
orbit-without-direction = kamery { $id } se dívají opačnými směry a nemají společnou osu

no-such-object = scéna nemá objekt { $id }
no-such-object-of = scéna nemá objekt { $id }; objekty scény: { $objects }
no-such-object-near = scéna nemá objekt { $id }; měli jste na mysli { $near }?
not-an-object = { $id } je { $kind }, ne objekt
two-inputs = scéna a paprsky nemohou být současně na standardním vstupu
no-question = chybí otázka
not-a-pixel = v obrázku o velikosti { $width }x{ $height } pixelů není pixel { $x },{ $y }
no-ray-in-pixel = projekce kamery nemá v pixelu { $x },{ $y } žádný paprsek
ray-out-of-range = tento paprsek je mimo rozsah čísel této přesnosti
hits-out-of-range = tento paprsek protíná scénu mimo rozsah čísel této přesnosti
too-many-occurrences = bod leží v mezích příliš mnoha výskytů sdílených objektů
no-inverse = transformace nemá ve dvojité přesnosti inverzi
point-out-of-range = transformace přesune bod mimo rozsah čísel dvojité přesnosti
line-unreadable = nelze přečíst: { $reason }
line-too-long = řádek je delší než { $max } bajtů
number-out-of-range = { $word } je mimo rozsah
not-a-number = { $word } není číslo
decimal-commas = čísla mají desetinnou tečku: { $number }
wrong-count = { $expected ->
    [one] očekává se { $expected } číslo
    [few] očekávají se { $expected } čísla
   *[other] očekává se { $expected } čísel
}, nalezeno jich je { $found }
zero-direction = směr je nulový vektor

## Srovnávání

no-program = program { $program } není nainstalován: získáte ho { $how } (hledalo se `{ $path }`)
no-such-program = program { $path } neexistuje
program-failed = { $program } selhal:
    { $said }
program-late = program { $program } neskončil do { $seconds } s, a proto byl ukončen: dejte mu víc času volbou `--timeout`, nebo zvolte { $instead }
crosscheck-late-povray = menší `--size` nebo `--depth`
crosscheck-late-mitsuba = menší `--size`
program-strange = { $program }: { $what }

## Převod

camera-nowhere = kamera { $id } nikam nehledí
camera-of-no-lens = matice projekce kamery { $id } nemá paprsky, které by POV-Ray mohl sledovat: nevycházejí z jednoho bodu ani nejsou rovnoběžné
camera-of-no-squares = kamera { $id } nemá při { $size } čtvercové pixely a takovou kameru Mitsuba nezná: zvolte --size { $other }
camera-of-never-squares = kamera { $id } nemá při { $size } čtvercové pixely; takovou kameru Mitsuba nezná a žádná jiná --size nepomůže
too-many-triangles = bylo by třeba nejméně { $needed } trojúhelníků, ale vytvoří se jich nejvýše { $most }: zvolte větší --tolerance nebo menší část scény
too-many-to-count = --tolerance je příliš malá: trojúhelníků by bylo tolik, že je nelze ani spočítat, a vytvoří se jich nejvýše { $most }: zvolte větší
too-many-joined = vzájemně se { $solids ->
    [one] překrývá { $solids } těleso
    [few] překrývají { $solids } tělesa
   *[other] překrývá { $solids } těles
}, mezi nimi tvar { $shape }, a mají příliš mnoho trojúhelníků na to, aby se spojila: zvolte větší --tolerance nebo menší část scény
mesh-without-name = scéna ze standardního vstupu nemá jméno: zadejte pomocí -o, kam zapsat soubor { $format }
would-overwrite-image = { $path } je obrázek, který scéna používá, a byl by přepsán: zvolte pro výstup jiné jméno
sheet-format = ze jména { $path } nelze poznat, zda má přehled být obrázek, nebo stránka: jméno má končit na .png nebo .html
sheet-too-large = přehled by byl pro PNG příliš velký: zvolte menší --size nebo jiný počet sloupců (--columns)
sheet-picture-too-large = má { $width } × { $height } pixelů; do přehledu se berou obrázky nejvýše se 134 miliony pixelů
sheet-findings-broken = { $path } není výstup příkazu `zpg check --format json` (řádek { $line }, sloupec { $column }): zapište ho znovu, nebo ho smažte
sheet-findings-version = { $path } má verzi { $version }, kterou tento program nečte: zapište ho znovu příkazem `zpg check --format json`
no-pictures = ve složce { $path } nejsou žádné obrázky (*.png, *.jpg, *.webp, *.exr, *.pfm)
would-overwrite-picture = { $path } je obrázek ze složky a byl by přepsán: zvolte pro přehled jiné jméno
mesh-on-stdout = OBJ se skládá z několika souborů: zadejte jméno pomocí -o
binary-on-terminal = toto není text pro terminál: zadejte soubor pomocí -o, nebo do něj výstup přesměrujte
pictures-of-one-name = obrázky scén { $scene } a { $other } by se oba zapsaly do { $path }: vykreslete je zvlášť, nebo uveďte složku, ve které jsou obě
would-write-twice = { $path } by se zapsal dvakrát: zvolte pro jeden ze souborů jiné jméno
would-overwrite-scene = { $path } je sama scéna a byla by přepsána: zvolte pro výstup jiné jméno
many-files = převod má více souborů ({ $documents ->
    [one] { $documents } dokument
    [few] { $documents } dokumenty
   *[other] { $documents } dokumentů
}, { $meshes ->
    [one] { $meshes } síť
    [few] { $meshes } sítě
   *[other] { $meshes } sítí
}): zadejte pomocí -o, kam je zapsat, například -o scena.xml

## Scény jako JSON

json-deep = seznamy a objekty jsou do sebe vnořeny příliš hluboko
json-not-formatted = { $path } je scéna v JSON, a tu zpg fmt neupravuje
own-mistake = { $path }: zpg udělal chybu a práci s tímto souborem vzdal; nahlaste prosím chybu i se souborem a řádky nad touto zprávou
json-not-changed = { $path } je scéna v JSON, a tu zpg check jen čte: --fix, --diff a --add-allow pracují jen se záznamy
json-ends = není to JSON: text končí příliš brzy, něco není uzavřeno
json-syntax = není to JSON: tento znak sem nepatří
json-missing = chybí `{ $field }`: doplňte ho
json-twice = `{ $field }` je uvedeno dvakrát: jedno vynechte
json-no-field = `{ $field }` sem nepatří; patří sem { $known }
json-no-kind = druh `{ $kind }` neexistuje; existují { $known }
json-too-many = seznam je příliš dlouhý
json-out-of-range = číslo je příliš velké
json-expected = očekává se { $wanted }, uvedeno je: { $found }
json-number = číslo
json-whole-number = celé číslo od 0 do 4294967295
json-string = text v uvozovkách
json-list = seznam
json-list-of = seznam o délce { $length }
json-shorter-list = kratší seznam
json-object = objekt ve složených závorkách
json-version = verze { $found } není známa; známa je verze { $known }
json-not-before = odkazuje na uzel { $node }, který není před ním
json-no-node = uzel { $node } neexistuje
json-no-camera = kamera { $camera } neexistuje
json-id-range = ID je od 2 do { $max }, ne { $id }
json-id-taken = ID { $id } je již použito
json-colours = barvu má mít každý bod profilu, nebo žádný
json-normals = trojúhelník nemá žádnou normálu, má jednu nebo tři
json-image-name = tak se soubor s obrázkem jmenovat nemůže

## Použití

usage = Použití: { $usage }
usage-more = Více řekne `--help`.
usage-unknown = neočekávaný argument `{ $arg }`
usage-no-command = příkaz `{ $arg }` neexistuje
usage-missing = chybí: { $arg }
usage-twice = `{ $arg }` lze uvést jen jednou
usage-conflict = `{ $arg }` nelze uvést spolu s `{ $other }`
usage-no-value = `{ $arg }` potřebuje hodnotu
usage-flag = `{ $arg }` se píše bez hodnoty, ale uvedena je `{ $text }`
usage-value = `{ $text }` není hodnota pro `{ $arg }`
usage-not-text = některý argument není text v UTF-8
usage-values = možnosti jsou { $values }

# Co má ruff a co se v zpg jmenuje jinak, nebo to v něm není.

habit-add-allow = zpg má místo toho `zpg check --add-allow`
habit-analyze = `zpg plan` vypíše, které efekty scéna potřebuje
habit-angle = taková volba není; zorný úhel je poslední číslo záznamu kamery (-501)
habit-all-codes = všechny vypíše `zpg explain` bez argumentu
habit-axes = `zpg accuracy` porovnává víc hodnot; čeho, udává `--axes`, například `--axes samples,adaptive`
habit-background = taková volba není; pozadí je druhé číslo renderovacího záznamu (9999): ID barvy, nebo 0 pro černou
habit-behind-command = volby příkazu stojí za jeho jménem: `zpg check { $text }`
habit-cache = zpg si nic neukládá do mezipaměti
habit-called = v zpg je to `{ $text }`
habit-check = zpg má místo toho `zpg check`
habit-check-json = u `zpg check` je to `--format json`
habit-clock = taková volba není; číslo scény, které se mění snímek od snímku, udává `--set`, například `--frames 0-29 --set 9.fovy=30..60`
habit-completions = zpg má místo toho `zpg completions`
habit-config = `zpg check --show-settings` vypíše všechna nastavení a `--config` jedno změní
habit-convert = zpg má místo toho `zpg convert`
habit-crosscheck = zpg má místo toho `zpg crosscheck`
habit-declare = nic takového v zpg není: čísla scény stojí v jejím souboru
habit-default = tak je to i bez této volby: stačí `{ $text }` vynechat
habit-deny = zpg má místo toho `--deny warnings`
habit-dry-run = zpg má místo toho `--diff`
habit-exclude = zpg má místo toho `--exclude`, které nahrazuje `exclude` ze zpg.toml
habit-exit-non-zero = taková volba není; `--diff` nic nezapíše a skončí s kódem 1, když by se něco změnilo
habit-exit-zero = zpg má místo toho `--exit-zero`
habit-extension = taková volba není; zpg pozná scénu podle obsahu
habit-fix = zpg má místo toho `zpg check --fix`
habit-fix-only = taková volba není; `zpg check --fix` opraví, co lze, a vypíše, co zbývá; s `--exit-zero` skončí s kódem 0
habit-fixable = taková volba není; `--fix` opraví vše, co je jisté, a `--select` a `--ignore` vybírají, co se hledá
habit-fmt-output = taková volba není; `zpg fmt` zapisuje přímo do souborů a `zpg fmt - < scene.zpg` na standardní výstup
habit-format = u `zpg convert` je to `--to` nebo přípona v `-o`, u `zpg check` je to `--output-format`
habit-depth = zpg má místo toho `--depth`, například `--depth 5`
habit-frames = zpg má místo toho `--frames`, například `--frames 0-29 --set 9.fovy=30..60`
habit-from = zpg má místo toho `--from { $text }`
habit-gamma = taková volba není; obrázky se zapisují v sRGB a zesvětlí je `--exposure`
habit-gitignore = taková volba není; při procházení složek platí .gitignore vždy
habit-ignore = zpg má místo toho `--ignore`
habit-ignore-allow = taková volba není; komentáře, které povolují nálezy, platí vždy
habit-in-place = taková volba není; `zpg fmt` zapisuje přímo do souborů a `--diff` jen ukáže, co by změnil
habit-json = zpg má místo toho `--json`
habit-line-length = zpg má místo toho `--config format.width={ $length }`
habit-linter = všechny kódy vypíše `zpg explain`
habit-new = zpg má místo toho `zpg new`
habit-no-fix = taková volba není; bez `--fix` `zpg check` nic nezapíše
habit-no-option = tak je to i bez jakékoli volby
habit-none = takovou volbu zpg nemá
habit-output = soubor, do kterého se zapíše, udává `-o { $path }`
habit-output-format-explain = taková volba není; mimo terminál píše `zpg explain` v Markdownu
habit-output-format-fmt = taková volba není; co by se změnilo, ukáže `--diff`, a soubory vypíše `--check`
habit-per-file-ignores = zpg má místo toho {"`"}--config 'lint.per-file-ignores={"{"}"*" = ["W310"]{"}"}'`
habit-picture-format = formát určuje přípona v `-o`, například `-o obrazek.png`
habit-preview = taková volba není; všechna pravidla zpg jsou stálá
habit-probe-json = taková volba není; `zpg probe` vypisuje vždy JSON
habit-render = zpg má místo toho `zpg render`
habit-render-preview = taková volba není; `--quality draft` vykreslí obrázek rychle a `--watch` znovu po každé změně scény
habit-samples = zpg má místo toho `--samples`, nebo `--quality draft`, `good` či `final`
habit-scene-named = scéna se uvádí samotná, bez `{ $text }`
habit-scene = scéna se uvádí samotná, bez volby: `zpg render { $path }`
habit-seed = taková volba není; vzorky obrázku jsou vždy stejné
habit-server = zpg má místo toho `zpg lsp`
habit-show-fixes = taková volba není; co by `--fix` změnilo, ukáže `--diff`
habit-show-source = taková volba není; nálezy ukazují své řádky vždy a `--output-format concise` je vynechá
habit-silent = zpg má místo toho `--quiet`
habit-size-or-silent = v zpg je to `--size`, například `--size 640x480`; méně hlášení vypisuje s `--quiet`
habit-silent-or-size = v zpg je to `--quiet`; velikost obrázku udává `--size`, například `--size 640x480`
habit-size = zpg má místo toho `--size`, například `--size { $size }`
habit-target-version = taková volba není; jazyk scén má jedinou verzi
habit-to = zpg má místo toho `--to`, například `--to pov`
habit-translation = scénu převede `zpg convert { $scene } -o { $path }`
habit-threads = zpg má místo toho `--threads`, například `--threads { $threads }`
habit-verbose-render = taková volba není; co obrázek stál a kde, vypíše `--cost`, a které jevy potřebuje, `zpg plan`
habit-verbose = taková volba není; zpg vypíše vše, co našlo
habit-version = zpg má místo toho `zpg --version`
habit-view = zpg má místo toho `--view { $text }`; za `--camera` patří ID kamery

with-reason = { $what }: { $reason }
with-near = { $what }; měli jste na mysli { $near }?

expected-frames = očekávají se snímky jako 0-99, nebo jeden, například 7
expected-set = očekává se ID.PARAMETR=OD..DO, například 9.fovy=30..60
expected-parameter = `{ $text }` není jméno čísla: očekává se jméno jako 9.fovy, 5.x[3] nebo 5@7.x
expected-orbit = očekává se ID kamery a stupně, například 9,360
expected-fps = očekává se celé číslo od 1 do 1000
expected-size = očekává se ŠxV, například 640x480
not-pixels = `{ $text }` není počet pixelů
expected-crop = očekává se X,Y,Š,V v pixelech, například 200,100,64,64
expected-tile = očekává se díl, například 3/8, nebo několik dílů, například 3-5/8; počítají se od 1
expected-pixel = očekává se X,Y v pixelech, například 320,240
expected-lines = řádky se zadávají jako 3-9 nebo 3
expected-length = očekává se délka větší než 0
expected-difference = očekává se číslo větší než 0, nejvýše 255
expected-columns = očekává se celé číslo od 1 do 10000
expected-thumbnail = očekává se ŠxV od 32x32 do 1024x1024
expected-tolerance = očekává se číslo větší než 0, nejvýše 1
decimal-comma = napište `{ $number }`, s desetinnou tečkou
expected-exposure = očekává se číslo větší než 0, například `0.5`
expected-cutoff = očekává se číslo od 0 do 1, například `0.001` nebo `1/4096`
expected-samples = očekává se celé číslo od 1 do 1048576
expected-whole-number = očekává se celé číslo od 0 do 4294967295
expected-time = očekává se čas jako 90s, 2m nebo 1h, nejvýše den
expected-runs = očekává se počet běhů od 1 do 100
expected-goal = očekává se počet kroků nad 0, nejvýše 255

## Editory

lsp-left-out = { $count ->
    [one] jeden další nález je vynechán
    [few] { $count } další nálezy jsou vynechány
   *[other] { $count } dalších nálezů je vynecháno
}
lsp-allow = Zde povolit { $code } ({ $name })
lsp-explain = Vysvětlit { $code } ({ $name })
lsp-fix-all = Provést všechny bezpečné opravy
lsp-renumber = Přečíslovat všechna ID podle pořadí v souboru
lsp-comment-out = Zakomentovat
lsp-comment-in = Odkomentovat
lsp-new-scene = nová scéna
lsp-profile-point = bod { $place }: { $name }
lsp-profile-colour = barva bodu { $place }: { $name }
lsp-render = Vykreslit
lsp-preview = Náhled
lsp-crosscheck = Porovnat s POV-Rayem
lsp-used = použito { $count }×
lsp-no-id = zde není žádné ID
lsp-render-id = 1 je ID renderovacího záznamu a jiné být nemůže
lsp-reserved-id = 1 je vyhrazeno renderovacímu záznamu
lsp-not-an-id = { $text } není ID: ID je celé číslo od 2 do { $max }
lsp-id-taken = { $id } je již použito na řádku { $line }
explain-in-a-scene = Ve scéně
explain-also = Viz též: { $list }
explain-help = Více řekne `{ $text }`.
explain-colour = Ve scéně je tato barva { $number }: její lineární podíly červené, zelené a modré. Objektu ji dá záznam { $text }; více řekne `zpg explain { $code }`.
explain-help-option = Více řekne `{ $text }` u `{ $option }`.
lsp-no-uri = { $text } není URI
lsp-no-command = zpg nemá příkaz { $text }
lsp-no-target = zpg zde scénu do { $text } nepřevádí
lsp-missing = soubor { $path } neexistuje
lsp-unreadable = zprávu { $method } nelze přečíst, je vynechána: { $reason }
lsp-no-edits = editor neprovádí úpravy, které mu zpg pošle; může si místo nich vyžádat akci { $kind }
lsp-has-errors = { $count ->
    [one] ve scéně je chyba na řádku { $line }: { $message }
    [few] ve scéně jsou { $count } chyby, první na řádku { $line }: { $message }
   *[other] ve scéně je { $count } chyb, první na řádku { $line }: { $message }
}
lsp-stopped = zastaveno
lsp-cannot-run = zpg selhalo: { $reason }
